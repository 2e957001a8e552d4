// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Ranges of sliders: usual values, not limits. A value outside widens the range.

import { convert, rounded, split } from "./quantity.js";

/// Range of a machine of the catalogue, in its own words.
function rangeOfMill(mill, unit) {
  const [least, most] = [split(mill?.least ?? ""), split(mill?.most ?? "")];
  if (!most) return null;
  const to = convert(most.number, most.unit, unit);
  if (to === null) return null;
  return { least: least ? convert(least.number, least.unit, unit) : to / 20, most: to };
}

/// The usual range of a field in `unit`, or null.
function usualOf({ usual, whole }, unit) {
  const ends = usual && [usual.least, usual.most].map(split)
    .map((end) => convert(end.number, end.unit, unit));
  return ends && ends[0] !== null ? { least: ends[0], most: ends[1], log: usual.log, whole } : null;
}

/// `{ least, most, log, whole }` in `unit`, such that it contains `number`.
export function rangeOf(field, number, unit, mill) {
  const around = number === 0 ? { least: 0, most: 1, log: false }
    : { least: number / 5, most: number * 5, log: true };
  const range = { ...around, whole: field.whole, ...usualOf(field, unit) };
  if (/^mill\.(frequency|speed)$/.test(field.address)) Object.assign(range, rangeOfMill(mill, unit) ?? {});
  if (range.least > range.most) [range.least, range.most] = [range.most, range.least];
  return { ...range, least: Math.min(range.least, number), most: Math.max(range.most, number) };
}

const steps = 1000;

/// Place on the slider, a whole number from 0 to 1000.
export function placeOf(range, number) {
  const { least, most, log } = range;
  if (most <= least) return 0;
  const part = log && least > 0 ? Math.log(number / least) / Math.log(most / least)
    : (number - least) / (most - least);
  return Math.round(steps * Math.min(Math.max(part, 0), 1));
}

/// The number at a place, rounded to what a slider can set.
export function numberAt(range, place) {
  const { least, most, log, whole } = range;
  const part = place / steps;
  const exact = log && least > 0 ? least * (most / least) ** part : least + part * (most - least);
  if (whole) return Math.round(exact);
  if (log) return rounded(exact, exact > 0 ? 2 : 1);
  const step = 10 ** Math.floor(Math.log10((most - least) / 60));
  return rounded(Math.round(exact / step) * step, 9);
}

export const sliderSteps = steps;
