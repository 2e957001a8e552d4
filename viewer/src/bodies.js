// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bodies that are no spheres, drawn by their surface: one instanced mesh for each kind. Place and
// rotation of a body follow from the places of its spheres.

import {
  BufferAttribute, BufferGeometry, InstancedBufferAttribute, InstancedMesh, Matrix4, Vector3,
} from "three";

/// Three spheres that are far from each other and from a line: their numbers. The third is null if all lie
/// on a line.
function anchorsOf(places, each) {
  const at = (k) => new Vector3().fromArray(places, 3 * k);
  const farthest = (from) => {
    let best = 0;
    for (let k = 0; k < each; ++k) if (from(at(k)) > from(at(best)) + 1e-9) best = k;
    return best;
  };
  const a = farthest((p) => p.length());
  const b = farthest((p) => p.distanceTo(at(a)));
  const line = at(b).sub(at(a)).normalize();
  const off = (p) => p.sub(at(a)).cross(line).length();
  const c = farthest(off);
  return [a, b, off(at(c)) > 1e-3 * at(a).distanceTo(at(b)) ? c : null];
}

/// Orthonormal axes as columns: the first from a to b, the second towards c, or anywhere if there is no c.
function axesOf(a, b, c, out) {
  const x = b.clone().sub(a).normalize();
  const towards = c ? c.clone().sub(a)
    : Math.abs(x.z) < 0.9 ? new Vector3(0, 0, 1) : new Vector3(1, 0, 0);
  const z = x.clone().cross(towards).normalize();
  return out.makeBasis(x, z.clone().cross(x), z);
}

export class Bodies {
  /// `balls`: the matrices of its mesh hold the places of the spheres, which are hidden.
  constructor(kind, balls, material) {
    this.kind = kind;
    this.balls = balls;
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(kind.vertices, 3));
    geometry.setAttribute("normal", new BufferAttribute(kind.normals, 3));
    geometry.setIndex(new BufferAttribute(kind.triangles, 1));
    this.mesh = new InstancedMesh(geometry, material, kind.count);
    this.mesh.frustumCulled = false;
    this.mesh.castShadow = this.mesh.receiveShadow = true;
    this.mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(3 * kind.count), 3);
    this.anchors = anchorsOf(kind.places, kind.each);
    const [a, b, c] = this.anchors.map((k) => k === null ? null : new Vector3().fromArray(kind.places, 3 * k));
    this.origin = a;
    this.toAnchors = axesOf(a, b, c, new Matrix4()).transpose();
  }

  /// Follows the spheres.
  show() {
    const spheres = this.balls.mesh.instanceMatrix.array;
    const colours = this.balls.mesh.instanceColor.array;
    const turn = new Matrix4();
    const { first, count, each, radius } = this.kind;
    for (let n = 0; n < count; ++n) {
      const from = first + n * each;
      const place = (k) => k === null ? null : new Vector3().fromArray(spheres, 16 * (from + k) + 12);
      const [a, b, c] = this.anchors.map(place);
      const scale = spheres[16 * from] / radius; // 0 outside the jar
      axesOf(a, b, c, turn).multiply(this.toAnchors).scale(new Vector3(scale, scale, scale));
      turn.setPosition(a.sub(this.origin.clone().transformDirection(turn)
        .multiplyScalar(scale * this.origin.length())));
      turn.toArray(this.mesh.instanceMatrix.array, 16 * n);
      for (let k = 0; k < 3; ++k) this.mesh.instanceColor.array[3 * n + k] = colours[3 * from + k];
      for (let k = from; k < from + each; ++k)
        spheres[16 * k] = spheres[16 * k + 5] = spheres[16 * k + 10] = 0;
    }
    this.mesh.instanceMatrix.needsUpdate = this.mesh.instanceColor.needsUpdate = true;
  }
}
