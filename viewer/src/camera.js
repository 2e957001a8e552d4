// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Camera: direction (along the jar's axis, from the side, or the start view, which shows the plane
// of motion) and distance.

import { Quaternion, Vector3 } from "three";
import { isInJar } from "./data.js";
import { axisOfTurning, frameOfView, poseAt, wayOfCentre } from "./motion.js";

const up = new Vector3(0, 0, 1);
export const fieldOfView = 24; // degrees, vertical

const jarAxis = (data) =>
  new Vector3(0, 0, 1).applyQuaternion(new Quaternion().fromArray(data.jarTurn));

/// The viewing direction along the axis: from above, or from the front if the axis is horizontal.
function facing(axis) {
  const dot = Math.abs(axis.z) > 0.1 ? axis.z : axis.x - axis.y;
  return dot < 0 ? axis.clone().negate() : axis.clone();
}

/// Horizontal viewing direction, perpendicular to the jar's axis or, if this is vertical, to the
/// path of the jar's centre.
function sideOf(data) {
  const { reach } = wayOfCentre(data);
  const across = jarAxis(data).cross(up);
  if (across.length() < 0.1) across.crossVectors(reach, up);
  if (across.length() <= 0.1 * reach.length()) return new Vector3(0, -1, 0);
  across.normalize();
  return across.y > 0 ? across.negate() : across;
}

/// `direction` tilted by `degrees` towards `towards`.
function leant(direction, towards, degrees) {
  const rest = towards.clone().addScaledVector(direction, -towards.dot(direction)).normalize();
  const angle = (degrees * Math.PI) / 180;
  return direction.clone().multiplyScalar(Math.cos(angle)).addScaledVector(rest, Math.sin(angle));
}

/// Viewing direction on the plane of motion, slightly tilted to show depth.
function startOf(data) {
  const axis = axisOfTurning(data.jarTurn) ?? wayOfCentre(data).normal;
  const side = sideOf(data);
  if (!axis) return leant(side, up, 12);
  const front = facing(axis);
  if (Math.abs(front.z) > 0.7) return leant(front, side, 28);
  return leant(leant(front, new Vector3(-1, -1, 0), 14), up, 8);
}

/// Unit vectors from the target to the camera.
export function directionsOf(data) {
  return { start: startOf(data), axis: facing(jarAxis(data)), side: sideOf(data) };
}

/// Vertices of the jar in the frame of a view, over all frames [m]. The picture must contain them.
export function outlineOf(data, view) {
  const frames = Math.min(data.frames, 48);
  const corners = data.meshes.flatMap((mesh) => {
    const points = [];
    const stride = 3 * Math.ceil(mesh.vertices.length / 3 / 300);
    for (let i = 0; i < mesh.vertices.length; i += stride)
      points.push(new Vector3().fromArray(mesh.vertices, i));
    return points;
  });
  if (corners.length === 0) corners.push(...ballCorners(data));
  const outline = [];
  for (let k = 0; k < frames; ++k) {
    const pose = poseAt(data, (k / Math.max(frames - 1, 1)) * (data.frames - 1));
    const { origin, turn } = frameOfView(data, view, pose);
    for (const corner of corners)
      outline.push(corner.clone().applyQuaternion(pose.jar).add(pose.centre).sub(origin)
        .applyQuaternion(turn));
    if (view === "fixed") break;
  }
  return outline;
}

/// Bounding box of the balls in the first frame, for replays without a mesh.
function ballCorners(data) {
  let reach = 1e-6;
  for (let i = 0; i < 3 * data.count; ++i)
    if (isInJar(data.positions, i))
      reach = Math.max(reach, Math.abs(data.positions[i] * data.positionScale));
  return [-reach, reach].flatMap((x) => [-reach, reach].flatMap((y) =>
    [-reach, reach].map((z) => new Vector3(x, y, z))));
}

/// Sets the camera to look along `-direction`, at the distance at which the outline fills the
/// picture.
export function look(camera, controls, outline, direction) {
  // The up direction is undefined along the z axis; a small offset defines it.
  const from = Math.abs(direction.z) > 0.9999
    ? new Vector3(0, -1e-3, Math.sign(direction.z)).normalize() : direction.clone();
  camera.up.copy(up);
  camera.position.copy(from);
  camera.lookAt(0, 0, 0);
  camera.updateMatrixWorld();
  const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
  const above = new Vector3().setFromMatrixColumn(camera.matrixWorld, 1);
  const tall = Math.tan((camera.fov * Math.PI) / 360);
  const target = new Vector3();
  const distance = Math.max(placed(outline, from, right, tall * camera.aspect, target),
    placed(outline, from, above, tall, target));
  camera.position.copy(target).addScaledVector(from, 1.1 * distance);
  // The centre of rotation is the middle of the outline in depth as well.
  const depths = outline.map((point) => point.dot(from));
  const [near, far] = depths.reduce(([a, b], d) => [Math.max(a, d), Math.min(b, d)],
    [-Infinity, Infinity]);
  controls.target.copy(target).addScaledVector(from, (near + far) / 2);
  controls.update();
  return camera.position.distanceTo(controls.target);
}

/// Moves `target` along `axis` in the plane of the picture to the position from which the camera
/// contains the outline at the least distance. Returns this distance. `slope`: half the width of
/// the picture over its distance.
function placed(outline, from, axis, slope, target) {
  // A camera at offset c and depth d sees a point at offset x and depth z if
  // |x - c| <= slope (d - z).
  let [most, least] = [-Infinity, -Infinity];
  for (const point of outline) {
    const depth = slope * point.dot(from);
    most = Math.max(most, depth + point.dot(axis));
    least = Math.max(least, depth - point.dot(axis));
  }
  target.addScaledVector(axis, (most - least) / 2);
  return (most + least) / (2 * slope);
}
