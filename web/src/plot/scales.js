// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The limits and marks of axes.

import { powerOfTen, short } from "../format.js";

const shows = (value, log) => Number.isFinite(value) && (!log || value > 1e-300);

/// Values that an axis must hold.
function* valuesOf(series, key) {
  if (key === "x") return yield* series.x;
  yield* series.y;
  if (series.mark === "steps" || series.mark === "line") return;
  yield* series.low ?? [];
  yield* series.high ?? [];
}

function withAir([least, most], log) {
  if (log) return [least / 1.3, most * 1.3];
  const room = 0.06 * (most - least);
  return [least >= 0 && least < 0.5 * most ? 0 : least - room, most + room];
}

/// Limits [least, most] of the axis `key`, "x" or "y", of a plot.
export function limits(plot, key) {
  const { log, least, most } = plot[key];
  let [low, high] = [Infinity, -Infinity];
  for (const series of plot.series)
    for (const value of valuesOf(series, key))
      if (shows(value, log)) [low, high] = [Math.min(low, value), Math.max(high, value)];
  if (!(low <= high)) [low, high] = log ? [0.1, 1] : [0, 1];
  if (high - low <= 1e-9 * Math.max(Math.abs(low), Math.abs(high)))
    [low, high] = log ? [low / 2, 2 * low] : [low - 0.5 * Math.max(Math.abs(low), 1), low + 0.5 * Math.max(Math.abs(low), 1)];
  const whole = key === "x" && plot.series.every(({ mark }) => mark === "steps" || mark === "line");
  if (!whole) [low, high] = withAir([low, high], log);
  return [shows(least, log) ? least : low, shows(most, log) ? most : high];
}

/// Whether an axis may be logarithmic: some of its values, and none below zero.
export const mayBeLog = (plot, key) => plot.series.some((series) => series[key].some((v) => v > 0)) &&
  plot.series.every((series) => series[key].every((v) => v === null || v >= 0));

/// Marks of a logarithmic axis: powers of ten, at most `most`; 1, 2 and 5 of each if there are few.
export function logarithmicMarks(least, most, atMost) {
  const [low, high] = [Math.ceil(Math.log10(least) - 1e-9), Math.floor(Math.log10(most) + 1e-9)];
  const step = Math.max(1, Math.ceil((high - low + 1) / Math.max(1, atMost)));
  const marks = [];
  for (let power = low - 1; power <= high; ++power)
    for (const digit of high - low < 2 ? [1, 2, 5] : [1]) {
      const at = Number(`${digit}e${power}`);
      if (at >= least * 0.999 && at <= most * 1.001 && (power - low) % step === 0) marks.push(at);
    }
  return marks;
}

/// Marks of a linear axis: about `wanted` round numbers.
export function linearMarks(least, most, wanted) {
  const rough = (most - least) / wanted;
  if (!(rough > 1e-9 * Math.max(Math.abs(least), Math.abs(most)))) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].find((digit) => digit * power >= rough * 0.999) * power;
  const first = Math.ceil(least / step - 1e-9), last = Math.floor(most / step + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => (first + i) * step);
}

/// Place of a value on an axis: 0 at its lower end, 1 at its upper one.
export const onAxis = (value, [least, most], log) => log
  ? (Math.log(value) - Math.log(least)) / (Math.log(most) - Math.log(least)) : (value - least) / (most - least);

/// The text of a mark: "10⁻⁵" instead of "1.0 × 10⁻⁵" on a logarithmic axis.
export function markText(value, log) {
  const far = log && (value >= 1e4 || value < 0.9e-3) && /^1e/.test(value.toExponential(6).replace(".000000", ""));
  return far ? powerOfTen(Math.round(Math.log10(value))) : short(value);
}
