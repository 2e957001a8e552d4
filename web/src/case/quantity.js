// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities with units, such as "10 Hz", and the units that are offered for them.

// Units by symbol: `{ unit, si, factor, offset, offered }`, as the program lists them.
let known = new Map();

/// Tells which units there are: `mahlwerk list units --json`.
export function useUnits(units) {
  known = new Map(units.map((each) => [each.unit, each]));
}

/// Number and unit of a value of a case; the unit of a pure number is "". Null for other values, and
/// for sieves ("200 mesh"), whose numbers are no measure.
export function split(value) {
  if (typeof value === "number") return { number: value, unit: "" };
  const found = typeof value === "string" &&
    value.trim().match(/^([+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)\s*([^\d\s].*)?$/i);
  return found && found[2] !== "mesh" ? { number: Number(found[1]), unit: found[2] ?? "" } : null;
}

/// The value of a case: a pure number, or a text with a unit.
export const join = (number, unit) => (unit === "" ? number : `${number} ${unit}`);

/// The units that may replace `unit`, the largest first, except for a unit of its own.
export function unitsFor(unit) {
  const { si } = known.get(unit) ?? {};
  return si === undefined ? [unit] : [...known.values()]
    .filter((each) => each.si === si && (each.offered || each.unit === unit))
    .sort((a, b) => b.factor - a.factor).map((each) => each.unit);
}

/// The number in another unit, or null if the units do not measure the same.
export function convert(number, from, to) {
  const [a, b] = [known.get(from), known.get(to)];
  if (a?.si !== b?.si || !a) return from === to ? number : null;
  return rounded((number * a.factor + a.offset - b.offset) / b.factor, 9);
}

export const rounded = (number, digits) => Number(number.toPrecision(digits));
