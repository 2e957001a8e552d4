// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The ball that the reader has picked: its path over the whole replay, and its speed.

import { Vector3 } from "three";
import { isInJar } from "./data.js";
import { between, frameOfView, poseAt } from "./motion.js";
import { energyAt, multipleOf, speedAt, spinAt } from "./quantities.js";
import { short } from "./words.js";

/// Colour of the picked ball and of its path.
export const pickedColour = 0xff5a1f;

/// Where a ball is at frame `f` in a view [m]; null outside the jar.
function placeAt(data, view, ball, f) {
  const at = 3 * (data.count * f + ball);
  if (!isInJar(data.positions, at)) return null;
  const pose = poseAt(data, f);
  const seen = frameOfView(data, view, pose);
  return new Vector3().fromArray(data.positions, at).multiplyScalar(data.positionScale)
    .add(pose.centre).sub(seen.origin).applyQuaternion(seen.turn);
}

/// The path of a ball in a view as pairs of points. A ball that leaves a side of a periodic jar and returns at the
/// other has a gap there: `reach` [m] is half the size of the picture.
export function pathOf(data, view, ball, reach) {
  const points = [];
  let last = null;
  for (let f = 0; f < data.frames; ++f) {
    const place = placeAt(data, view, ball, f);
    if (last && place && last.distanceTo(place) < reach)
      points.push(...last.toArray(), ...place.toArray());
    last = place;
  }
  return points;
}

/// What is known of a ball at a frame, line by line, in the words `text`. `span`: the time of the replay, as text.
export function linesOf(data, ball, frame, span, text) {
  const step = between(data, frame);
  const energy = data.masses && energyAt(data, step, ball);
  const { factor, unit } = multipleOf(energy ?? 1, "J");
  const numbers = [`${short(speedAt(data, step, ball))} m/s`];
  if (data.spins) numbers.push(`${short(spinAt(data, step, ball))} rad/s`);
  if (data.masses) numbers.push(`${short(energy / factor)} ${unit}`);
  const first = text.picked({ number: ball + 1, body: data.bodies.length > 0,
    kind: data.speciesNames[data.species[ball]] });
  const hits = data.hits?.ofBalls;
  return [first, numbers.join(", "), ...(hits ? [text.hitsOf(hits[ball], span)] : [])];
}
