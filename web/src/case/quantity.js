// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities with units, such as "10 Hz", and the units that are offered for them.

// Factor of each unit to the first of its family.
const families = [
  { Hz: 1, rpm: 1 / 60, "rad/s": 1 / (2 * Math.PI) },
  { m: 1, cm: 1e-2, mm: 1e-3, um: 1e-6 },
  { m3: 1, l: 1e-3, ml: 1e-6 },
  { kg: 1, g: 1e-3, mg: 1e-6 },
  { s: 1, ms: 1e-3, us: 1e-6, min: 60, h: 3600 },
  { rad: 1, deg: Math.PI / 180 },
  { "kg/m3": 1, "g/cm3": 1e3 },
  { "m/s": 1, "mm/s": 1e-3 },
  { Pa: 1, MPa: 1e6, GPa: 1e9 },
  { "": 1, "%": 1e-2 },
];

const familyOf = (unit) => families.find((family) => unit in family);

/// Number and unit of a value of a case; the unit of a pure number is "". Null for other values.
export function split(value) {
  if (typeof value === "number") return { number: value, unit: "" };
  const found = typeof value === "string" &&
    value.trim().match(/^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([^\d\s].*)?$/i);
  return found ? { number: Number(found[1]), unit: found[2] ?? "" } : null;
}

/// The value of a case: a pure number, or a text with a unit.
export const join = (number, unit) => (unit === "" ? number : `${number} ${unit}`);

/// The units that may replace `unit`.
export function unitsFor(unit) {
  const family = familyOf(unit);
  return family ? Object.keys(family) : [unit];
}

/// The number in another unit, or null if the units do not measure the same.
export function convert(number, from, to) {
  const family = familyOf(from);
  if (!family || !(to in family)) return from === to ? number : null;
  return rounded((number * family[from]) / family[to], 9);
}

export const rounded = (number, digits) => Number(number.toPrecision(digits));
