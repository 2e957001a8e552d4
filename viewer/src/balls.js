// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// All balls as one instanced sphere. Only the positions and colours of the balls change with time. Bodies
// that are no spheres have surfaces of their own (bodies.js).

import {
  BufferAttribute, Color, Group, IcosahedronGeometry, InstancedBufferAttribute, InstancedMesh,
  MeshStandardMaterial,
} from "three";
import { mergeVertices } from "three/examples/jsm/utils/BufferGeometryUtils.js";
import { Bodies } from "./bodies.js";
import { colourAt, speciesColours } from "./colours.js";
import { isInJar } from "./data.js";
import { between } from "./motion.js";
import { pickedColour } from "./picked.js";

const trianglesInAll = 2.5e6; // estimate: a laptop draws this number smoothly

const spheres = new Map(); // by detail; they are kept, because making one takes long

function sphereFor(count) {
  const wanted = Math.floor(Math.sqrt(trianglesInAll / (20 * Math.max(count, 1)))) - 1;
  const detail = Math.min(Math.max(wanted, 2), 20);
  if (!spheres.has(detail)) spheres.set(detail, sphereOf(detail));
  return spheres.get(detail);
}

function sphereOf(detail) {
  const sphere = new IcosahedronGeometry(1, detail);
  sphere.deleteAttribute("uv");
  sphere.deleteAttribute("normal");
  const shared = mergeVertices(sphere, 1e-5);
  shared.setAttribute("normal", new BufferAttribute(shared.attributes.position.array, 3));
  return shared;
}

/// Whether the geometry of an object outlives it.
export const keepsGeometry = (part) => [...spheres.values()].includes(part.geometry);

export class Balls {
  constructor(data) {
    this.data = data;
    const material = new MeshStandardMaterial({ roughness: 0.32, metalness: 0.12 });
    this.mesh = new InstancedMesh(sphereFor(data.count), material, data.count);
    this.mesh.frustumCulled = false; // the bounds of the mesh do not follow the balls
    this.mesh.castShadow = this.mesh.receiveShadow = true;
    this.mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(3 * data.count), 3);
    this.bodies = data.bodies.map((kind) => new Bodies(kind, this, material));
    this.group = new Group().add(this.mesh, ...this.bodies.map(({ mesh }) => mesh));
    this.picked = new Color(pickedColour);
    this.species = speciesColours.map((colour) => new Color(colour).toArray());
  }

  /// Sets positions and colours for the fractional frame `frame`. `scale`: of a quantity (scaleOf), or null: the
  /// colours are those of the kinds. `picked`: a ball, or null.
  show({ frame, scale, picked }) {
    const step = between(this.data, frame);
    this.place(step);
    if (scale === null) this.colourBySpecies();
    else this.colourBy(scale, step);
    if (picked !== null) this.picked.toArray(this.mesh.instanceColor.array, 3 * picked);
    for (const bodies of this.bodies) bodies.show();
    this.mesh.instanceMatrix.needsUpdate = true;
    this.mesh.instanceColor.needsUpdate = true;
  }

  /// The ball that the ray of a Raycaster meets first; null if it meets none. A body is named by its first sphere.
  hitBy(ray) {
    const meshes = [this.mesh, ...this.bodies.map(({ mesh }) => mesh)];
    for (const mesh of meshes) mesh.boundingSphere = null; // of another frame
    const [hit] = ray.intersectObjects(meshes, false);
    if (!hit) return null;
    const bodies = this.bodies.find(({ mesh }) => mesh === hit.object);
    return bodies ? bodies.kind.first + hit.instanceId * bodies.kind.each : hit.instanceId;
  }

  place({ low, high, part }) {
    const { count, positions, positionScale, radius } = this.data;
    const matrix = this.mesh.instanceMatrix.array;
    const a = 3 * count * low;
    const b = 3 * count * high;
    for (let i = 0; i < count; ++i) {
      const shown = isInJar(positions, a + 3 * i) && isInJar(positions, b + 3 * i);
      matrix[16 * i] = matrix[16 * i + 5] = matrix[16 * i + 10] = shown ? radius[i] : 0;
      for (let k = 0; k < 3; ++k) {
        const from = positions[a + 3 * i + k];
        const to = positions[b + 3 * i + k];
        matrix[16 * i + 12 + k] = positionScale * (from + part * (to - from));
      }
    }
  }

  colourBy(scale, step) {
    for (let i = 0; i < this.data.count; ++i)
      colourAt(scale.at(step, i), this.mesh.instanceColor.array, 3 * i);
  }

  colourBySpecies() {
    const { count, species } = this.data;
    for (let i = 0; i < count; ++i)
      this.mesh.instanceColor.array.set(this.species[species[i] % this.species.length], 3 * i);
  }
}
