// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The picture: balls, jar, light and camera, drawn for one moment and one view.

import {
  DirectionalLight, Group, HemisphereLight, PCFShadowMap, PerspectiveCamera, PMREMGenerator,
  Quaternion, Raycaster, Scene, Spherical, Vector2, Vector3, WebGLRenderer,
} from "three";
import { OrbitControls } from "three/examples/jsm/controls/OrbitControls.js";
import { RoomEnvironment } from "three/examples/jsm/environments/RoomEnvironment.js";
import { Balls, keepsGeometry } from "./balls.js";
import { directionsOf, fieldOfView, look, outlineOf } from "./camera.js";
import { carrierOf, plateOf, rimOf } from "./carrier.js";
import { isInJar } from "./data.js";
import { Hits } from "./hits.js";
import { lines, partOf, vesselOf } from "./jar.js";
import { axisOfTurning, frameOfView, poseAt } from "./motion.js";
import { pathOf, pickedColour } from "./picked.js";

const zUpToYUp = new Quaternion().setFromUnitVectors(new Vector3(0, 0, 1), new Vector3(0, 1, 0));
const rides = ["laboratory", "carrier"]; // views that show the carrier

function reachOf({ vertices }) {
  let reach = 0;
  for (let i = 0; i < vertices.length; i += 3)
    reach = Math.max(reach, Math.hypot(vertices[i], vertices[i + 1], vertices[i + 2]));
  return reach;
}

/// How far the balls of the first frame reach from the jar's centre [m].
function reachOfBalls({ count, radius, positions, positionScale }) {
  let reach = 1e-6;
  for (let i = 0; i < count; ++i) {
    if (!isInJar(positions, 3 * i)) continue;
    const [x, y, z] = positions.subarray(3 * i, 3 * i + 3);
    reach = Math.max(reach, radius[i] + positionScale * Math.hypot(x, y, z));
  }
  return reach;
}

const sameNumbers = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);

/// Whether vessel, parts and carrier of two replays look the same apart from their motion.
function sameBodies(a, b) {
  const turns = ({ jarTurn }) => axisOfTurning(jarTurn) !== null;
  const plate = (data) => (data.carrier ? plateOf(data).radius : 0);
  return a.meshes.length === b.meshes.length && turns(a) === turns(b) &&
    Math.abs(plate(a) - plate(b)) <= 1e-5 * plate(a) && a.meshes.every((mesh, i) =>
    !mesh.turn === !b.meshes[i].turn && sameNumbers(mesh.vertices, b.meshes[i].vertices) &&
      sameNumbers(mesh.triangles, b.meshes[i].triangles));
}

export class Stage {
  /// `context`: a WebGL 2 context of `canvas` that preserves its drawing buffer.
  constructor(canvas, context, data) {
    this.renderer = new WebGLRenderer({ canvas, context, antialias: true });
    this.renderer.shadowMap.enabled = true;
    this.renderer.shadowMap.type = PCFShadowMap;
    this.scene = new Scene();
    this.room = new Group(); // the laboratory, transformed to the view
    this.riding = new Group(); // at the jar's centre, axes of the laboratory
    this.scene.add(this.room.add(this.riding));
    this.camera = new PerspectiveCamera(fieldOfView, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.retired = []; // removed from the scene, but not yet freed
    this.addLight();
    this.addBodies(data);
  }

  /// Replaces everything that the data describe, except for bodies that are the same.
  renew(data) {
    const same = sameBodies(this.data, data);
    const old = [this.balls.group, ...(same ? [] : this.bodies.map((body) => body.group))];
    if (this.hits) old.push(this.hits.points);
    if (this.carrier && !same) old.push(this.carrier.group);
    for (const group of old) group.removeFromParent();
    this.retired.push(...old);
    this.addBodies(data, same);
  }

  /// Frees what was replaced, except for spheres, which are kept. This has to follow a picture of what came
  /// instead, because shaders that nothing uses are compiled again, which takes long.
  disposeOfRetired() {
    for (const group of this.retired.splice(0))
      group.traverse((part) => {
        if (!keepsGeometry(part)) part.geometry?.dispose();
        part.material?.dispose();
        part.dispose?.();
      });
  }

  /// `same`: the bodies are already there.
  addBodies(data, same = false) {
    this.data = data;
    this.directions = directionsOf(data);
    this.balls = new Balls(data);
    this.riding.add(this.balls.group);
    this.hits = data.hits?.count > 0 ? new Hits(data) : null;
    if (this.hits) this.riding.add(this.hits.points);
    if (!same) this.addVesselAndParts(data);
    this.reach = Math.max(...data.meshes.map(reachOf), reachOfBalls(data));
    this.fitShadow(this.key.shadow);
  }

  addVesselAndParts(data) {
    const still = data.meshes.filter((mesh) => !mesh.turn);
    const vessel = still.sort((a, b) => reachOf(b) - reachOf(a))[0];
    const turning = axisOfTurning(data.jarTurn) !== null;
    this.bodies = data.meshes.map((mesh) =>
      mesh === vessel ? vesselOf(mesh, turning) : partOf(mesh));
    this.riding.add(...this.bodies.map((body) => body.group));
    this.carrier = data.carrier ? carrierOf(data) : null;
    if (this.carrier) this.room.add(this.carrier.group);
  }

  fitShadow(shadow) {
    shadow.normalBias = 0.004 * this.reach;
    Object.assign(shadow.camera, { left: -this.reach, right: this.reach, bottom: -this.reach,
      top: this.reach, near: 0.5 * this.reach, far: 6 * this.reach });
    shadow.camera.updateProjectionMatrix();
  }

  addLight() {
    const rooms = new PMREMGenerator(this.renderer);
    this.scene.environment = rooms.fromScene(new RoomEnvironment(), 0.04).texture;
    this.scene.environmentIntensity = 0.3;
    rooms.dispose();
    this.sky = new HemisphereLight(0xffffff, 0xccd2da, 1.25);
    this.key = new DirectionalLight(0xffffff, 1.45);
    this.key.castShadow = true;
    const { shadow } = this.key;
    shadow.mapSize.set(2048, 2048);
    shadow.radius = 3;
    shadow.bias = -0.0005;
    this.scene.add(this.sky, this.key, this.key.target);
  }

  paint(theme) {
    this.renderer.setClearColor(theme.box, 1);
    for (const body of this.bodies) body.paint(theme);
    this.carrier?.paint(theme);
  }

  /// Size of the picture in CSS pixels, and device pixels per CSS pixel.
  resize(width, height, ratio) {
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
    this.camera.aspect = width / height;
    this.camera.updateProjectionMatrix();
  }

  /// Looks from `direction` ("start", "axis", "side" or a vector). The picture contains the whole
  /// path of the jar.
  lookFrom(direction, view) {
    const outline = outlineOf(this.data, view);
    if (this.carrier && view === "laboratory") outline.push(...rimOf(plateOf(this.data)));
    if (view === "carrier") outline.push(new Vector3()); // the mill's axis
    const far = look(this.camera, this.controls, outline, this.directions[direction] ?? direction);
    Object.assign(this.camera, { near: 0.02 * far, far: 12 * far });
    Object.assign(this.controls, { minDistance: 0.1 * far, maxDistance: 6 * far });
    this.camera.updateProjectionMatrix();
  }

  /// The current direction from the target to the camera.
  direction() {
    return this.camera.position.clone().sub(this.controls.target).normalize();
  }

  /// Rotates the camera about its target [rad].
  orbit(right, up) {
    const arm = this.camera.position.clone().sub(this.controls.target);
    const ball = new Spherical().setFromVector3(arm.applyQuaternion(zUpToYUp));
    ball.theta += right;
    ball.phi -= up;
    arm.setFromSpherical(ball.makeSafe()).applyQuaternion(zUpToYUp.clone().invert());
    this.camera.position.copy(this.controls.target).add(arm);
    this.controls.update();
  }

  nearer(by) {
    this.camera.position.sub(this.controls.target).multiplyScalar(by).add(this.controls.target);
    this.controls.update();
  }

  /// The ball at a place of the picture, -1 to 1 to the right and upwards; null if there is none.
  ballAt(x, y) {
    const ray = new Raycaster();
    this.scene.updateMatrixWorld();
    ray.setFromCamera(new Vector2(x, y), this.camera);
    return this.balls.hitBy(ray);
  }

  /// Shows the path of a ball in a view, or none.
  showPath(ball, view) {
    if (this.path) {
      this.path.removeFromParent();
      this.retired.push(this.path);
      this.path = null;
    }
    const points = ball === null ? [] : pathOf(this.data, view, ball, this.reach);
    if (points.length === 0) return;
    this.path = lines(points, 2, 0.9);
    this.path.material.color.set(pickedColour);
    this.scene.add(this.path);
  }

  /// Pixels of a metre at the target of the camera, in a picture of `height` pixels.
  pixelsOfMetre(height) {
    const far = this.camera.position.distanceTo(this.controls.target);
    return height / (2 * far * Math.tan((fieldOfView * Math.PI) / 360));
  }

  /// Draws the fractional frame `frame` in a view; `scale`, `picked` as in Balls, `life` as in Hits.
  draw({ frame, view, scale, picked, life }) {
    const pose = poseAt(this.data, frame);
    const seen = frameOfView(this.data, view, pose);
    this.room.quaternion.copy(seen.turn);
    this.room.position.copy(seen.origin).negate().applyQuaternion(seen.turn);
    this.riding.position.copy(pose.centre);
    this.bodies.forEach((body, i) => {
      body.group.quaternion.copy(pose.parts[i] ?? pose.jar);
      if (pose.shifts[i]) body.group.position.copy(pose.shifts[i]);
    });
    if (this.carrier) {
      this.carrier.group.visible = rides.includes(view);
      this.carrier.group.quaternion.copy(pose.carrier);
    }
    this.balls.show({ frame, scale, picked });
    this.hits?.points.quaternion.copy(pose.jar);
    this.hits?.show(frame, life, this.renderer.getPixelRatio());
    this.light(pose.centre.clone().sub(seen.origin).applyQuaternion(seen.turn));
    this.renderer.render(this.scene, this.camera);
    this.disposeOfRetired();
    return this.weight(seen.turn);
  }

  /// The key light comes from above and left behind the camera in every view. Its shadow map covers
  /// the jar.
  light(jar) {
    this.camera.updateMatrixWorld();
    const axis = (i) => new Vector3().setFromMatrixColumn(this.camera.matrixWorld, i);
    const from = axis(0).multiplyScalar(-0.45).addScaledVector(axis(1), 0.75).add(axis(2));
    this.key.position.copy(jar).addScaledVector(from.normalize(), 3 * this.reach);
    this.key.target.position.copy(jar);
    this.sky.position.copy(axis(1)).addScaledVector(axis(2), 0.5);
  }

  /// Direction of gravity in camera axes: right, up, towards the camera.
  weight(turn) {
    const down = new Vector3(0, 0, -1).applyQuaternion(turn);
    return down.transformDirection(this.camera.matrixWorldInverse);
  }
}
