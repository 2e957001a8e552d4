// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Position and rotation of jar, carrier and parts at any time. Between frames, positions are
// interpolated linearly and rotations along the shortest arc.

import { Quaternion, Vector3 } from "three";

const turnAt = (list, f) => new Quaternion().fromArray(list, 4 * f).normalize();
const placeAt = (list, f) => new Vector3().fromArray(list, 3 * f);

const turnBetween = (list, { low, high, part }) =>
  turnAt(list, low).slerp(turnAt(list, high), part);

/// The two frames around the fractional frame `frame` (0 to F - 1), and the fraction between them.
export function between(data, frame) {
  const last = data.frames - 1;
  const at = Math.min(Math.max(frame, 0), last);
  const low = Math.min(Math.floor(at), last);
  return { low, high: Math.min(low + 1, last), part: at - low };
}

export function timeOf(data, frame) {
  const { low, high, part } = between(data, frame);
  return data.times[low] + part * (data.times[high] - data.times[low]);
}

/// Fractional frame at a time [s]; the inverse of timeOf.
export function frameOf(data, time) {
  let low = 0;
  let high = data.frames - 1;
  if (time <= data.times[low]) return low;
  if (time >= data.times[high]) return high;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (data.times[middle] <= time) low = middle;
    else high = middle;
  }
  return low + (time - data.times[low]) / (data.times[high] - data.times[low]);
}

/// Centre of the jar [m] and rotations, all relative to the laboratory's axes.
export function poseAt(data, frame) {
  const step = between(data, frame);
  const carrier = turnBetween(data.carrierTurn, step);
  // In the frame of the carrier the jar's centre moves little; linear interpolation in that frame
  // gives an arc in the laboratory.
  const seen = (f) =>
    placeAt(data.jarCentre, f).applyQuaternion(turnAt(data.carrierTurn, f).invert());
  const centre = seen(step.low).lerp(seen(step.high), step.part).applyQuaternion(carrier);
  const parts = data.meshes.map((mesh) => mesh.turn && turnBetween(mesh.turn, step));
  const shifts = data.meshes.map((mesh) => mesh.shift &&
    placeAt(mesh.shift, step.low).lerp(placeAt(mesh.shift, step.high), step.part));
  return { centre, carrier, jar: turnBetween(data.jarTurn, step), parts, shifts };
}

/// Frames of reference that can be selected. `key` is the value of data-view.
export function viewsOf(data, text) {
  const views = ["laboratory", "centre", "fixed"].map((key) => ({ key, ...text.views[key] }));
  if (data.carrier) views.splice(1, 0, { key: "carrier", ...text.carrier(data.carrier) });
  return views;
}

/// Transformation from the laboratory to a view: x_view = turn (x_laboratory - origin). A rotating
/// view has the orientation of the first frame, so a horizontal drum stays horizontal.
export function frameOfView(data, view, pose) {
  const origin = new Vector3();
  const turn = new Quaternion();
  if (view === "centre" || view === "fixed") origin.copy(pose.centre);
  if (view === "fixed") turn.copy(turnAt(data.jarTurn, 0)).multiply(pose.jar.clone().invert());
  if (view === "carrier")
    turn.copy(turnAt(data.carrierTurn, 0)).multiply(pose.carrier.clone().invert());
  return { origin, turn };
}

/// Mean axis of rotation over all frames, a unit vector in laboratory axes; null if there is hardly
/// any rotation. Oscillations count as rotation.
export function axisOfTurning(turns) {
  const sum = new Vector3();
  let total = 0;
  for (let f = 0; 4 * (f + 1) < turns.length; ++f) {
    const step = turnAt(turns, f + 1).multiply(turnAt(turns, f).invert());
    const half = new Vector3(step.x, step.y, step.z);
    if (step.w * half.dot(sum) < 0) half.negate();
    else if (step.w < 0 && sum.lengthSq() === 0) half.negate();
    total += half.length();
    sum.add(half);
  }
  return total > 0.05 ? sum.normalize() : null;
}

/// Path of the jar's centre: its mean, the vector from there to the farthest point, and the normal
/// of the enclosed area (null if the path encloses none).
export function wayOfCentre(data) {
  const places = Array.from({ length: data.frames }, (_, f) => placeAt(data.jarCentre, f));
  const middle = places.reduce((a, b) => a.add(b), new Vector3()).divideScalar(places.length);
  const reach = new Vector3();
  const area = new Vector3();
  places.forEach((place, f) => {
    const arm = place.clone().sub(middle);
    if (arm.lengthSq() > reach.lengthSq()) reach.copy(arm);
    if (f > 0) area.add(places[f - 1].clone().sub(middle).cross(arm));
  });
  const flat = area.length() > 0.2 * reach.lengthSq() && reach.lengthSq() > 0;
  return { middle, reach, normal: flat ? area.normalize() : null };
}
