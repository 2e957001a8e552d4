// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Numbers as text: value, interval and unit, as the program prints them.

const prefixes = { "-15": "f", "-12": "p", "-9": "n", "-6": "µ", "-3": "m", 0: "", 3: "k", 6: "M", 9: "G" };
const scaled = new Set(["J", "W", "m", "s", "Pa", "m/s", "N m", "J/g", "W/g", "kg"]);
const narrow = "\u202f";
const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

const raised = (power) => String(power).replace("-", "⁻")
  .replace(/\d/g, (digit) => superscripts[digit]);

/// "12 345" with a narrow no-break space between thousands.
export const grouped = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, narrow);

function fixed(number, decimals) {
  const [whole, part] = number.toFixed(Math.min(Math.max(decimals, 0), 20)).split(".");
  return (Math.abs(number) >= 1e4 ? grouped(whole) : whole) + (part ? `.${part}` : "");
}

/// The power of ten, a multiple of three, in which the number is written.
function powerOf(number, unit) {
  if (number === 0 || !Number.isFinite(number)) return 0;
  const power = 3 * Math.floor((Math.log10(Math.abs(number)) + 1e-9) / 3);
  if (unit === "kg") return power; // written in grams
  return Math.min(Math.max(power, -15), 9);
}

function unitOf(unit) {
  if (unit === "1") return "";
  if (unit === "1/s") return "/s";
  return unit.replaceAll("m2", "m²").replaceAll("m3", "m³");
}

/// Parts of a quantity as text: `value`, `interval` (half width, or "") and `unit`.
export function parts(quantity) {
  let { value, ci95, unit = "" } = quantity;
  if (!Number.isFinite(value)) return { value: "–", interval: "", unit: unitOf(unit) };
  if (unit === "kg") [value, ci95, unit] = [value * 1e3, ci95 == null ? ci95 : ci95 * 1e3, "g"];
  const power = scaled.has(unit) || unit === "g" ? powerOf(value, unit) : 0;
  const shown = value / 10 ** power;
  const half = ci95 == null ? null : ci95 / 10 ** power;
  const label = power === 0 ? unitOf(unit) : prefixes[power] + unitOf(unit);
  const tiny = shown !== 0 && Math.abs(shown) < 1e-3;
  if (tiny) return { value: exponential(shown), interval: "", unit: label };
  const decimals = half > 0 ? decimalsFor(half, 2) : decimalsFor(shown, 4);
  return { value: fixed(shown, decimals), interval: half > 0 ? fixed(half, decimals) : "",
    unit: label };
}

function exponential(number) {
  const [digits, power] = number.toExponential(1).split("e");
  return `${digits} × 10${raised(Number(power))}`;
}

function decimalsFor(number, digits) {
  if (number === 0) return 0;
  return Math.max(0, digits - 1 - Math.floor(Math.log10(Math.abs(number))));
}

/// "243 ± 16 mW".
export function quantityText(quantity) {
  const { value, interval, unit } = parts(quantity);
  const both = interval ? `${value} ± ${interval}` : value;
  return unit ? `${both}\u00a0${unit}` : both;
}

/// About three digits, for axes and short texts.
export const short = (number) =>
  Math.abs(number) >= 1e5 || (number !== 0 && Math.abs(number) < 1e-3)
    ? exponential(number) : String(Number(number.toPrecision(3)));

/// A number with a prefix of the unit, for axes: "20 mW".
export function scaledText(number, unit) {
  const { value, unit: label } = parts({ value: Number(number.toPrecision(3)), unit });
  return `${String(Number(value.replaceAll(narrow, "")))}${label ? ` ${label}` : ""}`;
}
