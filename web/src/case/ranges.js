// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Ranges of sliders: usual values, not limits. A value outside widens the range.

import { convert, rounded, split } from "./quantity.js";

// Least and most, with the unit; `log`: equal ratios instead of equal steps; `whole`: whole numbers.
const usual = {
  "mill.frequency": { least: 1, most: 60, unit: "Hz" },
  "mill.amplitude": { least: 0.5, most: 60, unit: "mm" },
  "mill.speed": { least: 10, most: 1100, unit: "rpm" },
  "mill.speed %": { least: 5, most: 130, unit: "%" },
  "mill.swing": { least: 0.5, most: 20, unit: "deg" },
  "mill.arm": { least: 50, most: 400, unit: "mm" },
  "mill.orbit_radius": { least: 20, most: 300, unit: "mm" },
  "mill.ratio": { least: -4, most: 2, unit: "" },
  "mill.tilt": { least: 0, most: 90, unit: "deg" },
  "jar.diameter": { least: 5, most: 500, unit: "mm", log: true },
  "jar.height": { least: 2, most: 500, unit: "mm", log: true },
  "jar.volume": { least: 1, most: 1000, unit: "ml", log: true },
  "balls.count": { least: 1, most: 200, unit: "", log: true, whole: true },
  "balls.diameter": { least: 1, most: 60, unit: "mm", log: true },
  "balls.filling": { least: 1, most: 50, unit: "%" },
  "balls.density": { least: 1000, most: 16000, unit: "kg/m3" },
  "powder.mass": { least: 0.1, most: 100, unit: "g", log: true },
  "powder.size": { least: 0.01, most: 5, unit: "mm", log: true },
  "contact.restitution": { least: 0, most: 1, unit: "" },
  "contact.tangential_restitution": { least: -1, most: 1, unit: "" },
  "contact.friction": { least: 0, most: 1, unit: "" },
  "run.time": { least: 0.1, most: 100, unit: "s", log: true },
  "run.settle": { least: 0, most: 5, unit: "s" },
  "run.replicates": { least: 1, most: 20, unit: "", whole: true },
};

const withoutNumber = (address) => address.replace(/\.\d+\./, ".");

/// Range of a machine of the catalogue, in its own words.
function rangeOfMill(mill, unit) {
  const [least, most] = [split(mill?.least ?? ""), split(mill?.most ?? "")];
  if (!most) return null;
  const to = convert(most.number, most.unit, unit);
  if (to === null) return null;
  return { least: least ? convert(least.number, least.unit, unit) : to / 20, most: to };
}

/// `{ least, most, log, whole }` in `unit`, such that it contains `number`.
export function rangeOf(address, number, unit, mill) {
  const key = withoutNumber(address);
  const known = usual[unit === "%" && `${key} %` in usual ? `${key} %` : key];
  const ends = known && [known.least, known.most].map((end) => convert(end, known.unit, unit));
  let range = { ...known, least: number / 5, most: number * 5, log: known?.log ?? !known };
  if (ends && ends[0] !== null) range = { ...known, least: ends[0], most: ends[1] };
  if (/^mill\.(frequency|speed)$/.test(key)) Object.assign(range, rangeOfMill(mill, unit) ?? {});
  if (number === 0 && !known) Object.assign(range, { least: 0, most: 1, log: false });
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
