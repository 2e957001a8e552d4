// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Numbers as text: value, interval and unit, with the digits that the program prints
// (report/text/readable.cpp). tests/unit/report/numbers.json holds both to the same texts.

const prefixes = [[1e9, "G"], [1e6, "M"], [1e3, "k"], [1, ""], [1e-3, "m"], [1e-6, "µ"], [1e-9, "n"],
  [1e-12, "p"]];
const scaled = new Set(["J", "W", "m", "s", "N", "Pa", "W/g", "J/g", "N m", "W/m²", "g/h", "g/s", "g"]);
const signs = { 1: "", "1/s": "/s", deg: "°", degC: "°C", "ug/g/h": "µg/g/h", "m/s2": "m/s²",
  "m2/kg": "m²/kg" };
const superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";

export const powerOfTen = (power) => (power < 0 ? "10⁻" : "10") +
  String(Math.abs(power)).replace(/\d/g, (digit) => superscripts[digit]);

let words = { to: "to", infinite: "infinite" };

/// Takes the words between numbers from the language of the page.
export const useWords = (given) => (words = given);

const decade = (size) => Math.floor(Math.log10(size));

/// `number` with so many decimals; a tie goes to the even digit.
function fixedTo(number, decimals) {
  const exact = Math.abs(number).toFixed(Math.min(100, decimals + 60));
  const tie = /^50*$/.test(decimals ? exact.split(".")[1].slice(decimals) : exact.split(".")[1]);
  const text = number.toFixed(decimals);
  if (!tie || Number(text.at(-1)) % 2 === 0) return text;
  return (number - Math.sign(number) * 0.25 * 10 ** -decimals).toFixed(decimals);
}

/// The multiple of the unit for numbers of a size: `{ factor, unit }`.
function multiple(size, unit) {
  if (unit === "kg/s") {
    const base = size < 1e-6 ? 1e-3 / 3600 : 1e-3;
    const part = multiple(size / base, size < 1e-6 ? "g/h" : "g/s");
    return { factor: part.factor * base, unit: part.unit };
  }
  if (unit === "kg" && size < 1) {
    const part = multiple(1000 * size, "g");
    return { factor: part.factor / 1000, unit: part.unit };
  }
  if (!scaled.has(unit) || !(size >= 0.9995e-12) || !(size < 1e16)) return { factor: 1, unit };
  const big = (factor) => factor > 1 && /^[sm]/.test(unit); // no ks, no km
  for (const [factor, prefix] of prefixes)
    if (!big(factor) && size >= 0.9995 * factor) return { factor, unit: prefix + unit };
  return { factor: 1, unit };
}

/// The same with the sign of the unit, for axes.
export function multipleOf(size, unit) {
  const { factor, unit: made } = multiple(size, unit);
  return { factor, unit: signs[made] ?? made };
}

/// Decimals such that the half-width has two digits, or without one the value four.
function places(value, half) {
  const size = half > 0 ? half : Math.abs(value);
  return size === 0 ? 0 : Math.max((half > 0 ? 1 : 3) - decade(size), 0);
}

function fixed(value, half) {
  const decimals = places(value, half);
  let text = fixedTo(value, decimals);
  if (text.startsWith("-") && !/[1-9]/.test(text)) text = text.slice(1);
  return { value: text, interval: half > 0 ? fixedTo(half, decimals) : "" };
}

function scientific(value, half) {
  const power = decade(Math.abs(value)), scale = 10 ** power;
  const decimals = half > 0 ? Math.min(Math.max(places(value / scale, half / scale), 0), 9) : 1;
  return { value: fixedTo(value / scale, decimals), power,
    interval: half > 0 ? fixedTo(half / scale, decimals) : "" };
}

/// The text of an interval that leaves the quantity's range, by its ends; null for others.
function withinRange(value, half, least, most, { factor }) {
  const low = value - half, high = value + half;
  if (!(value >= least && value <= most) || !Number.isFinite(low)) return null;
  if (low >= least && high <= most) return null;
  const plain = half / factor >= 1e-3 || high >= most;
  const power = plain ? 0 : decade(half / factor), scale = factor * 10 ** power;
  const decimals = Math.min(places(value / scale, half / scale), 9);
  const shown = (end) => end === least || end === most
    ? String(Number((end / scale).toPrecision(6))) : fixedTo(end / scale, decimals);
  const text = `${shown(value)} (${shown(Math.max(low, least))} ${words.to} ${shown(Math.min(high, most))})`;
  return { value: shown(value), text: plain ? text : `[${text}] × ${powerOfTen(power)}` };
}

/// Parts of a quantity as text: `value`, `interval` (half width, or "") and `unit`, and all of them in
/// `number`. A quantity has value, ci95, unit, and `least` and `most` where it is bounded.
export function parts({ value, ci95 = null, unit = "1", least = -Infinity, most = Infinity }) {
  if (value === null || value === undefined || Number.isNaN(value))
    return { value: "-", interval: "", unit: "", number: "-" };
  if (!Number.isFinite(value)) return { value: words.infinite, interval: "", unit: "", number: words.infinite };
  const half = Number.isFinite(ci95) ? ci95 : NaN;
  const m = multiple(half > Math.abs(value) ? half : Math.abs(value), unit);
  const sign = signs[m.unit] ?? m.unit;
  const cut = ci95 === null ? null : withinRange(value, half, least, most, m);
  if (cut) return { value: cut.value, interval: "", unit: sign, number: cut.text };
  const v = value / m.factor, h = half / m.factor, size = Math.abs(v);
  if (!(h > 0) && unit === "1" && Number.isInteger(v) && size < 1e6)
    return { value: String(v), interval: "", unit: "", number: String(v) };
  const plain = size === 0 || (size >= 1e-3 && size < 1e7) || (h >= size && h >= 1e-3);
  const made = plain ? fixed(v, h) : scientific(v, h);
  const both = made.interval ? `${made.value} ± ${made.interval}` : made.value;
  if (plain) return { ...made, unit: sign, number: both };
  const power = ` × ${powerOfTen(made.power)}`;
  return { value: made.value + power, interval: made.interval ? made.interval + power : "", unit: sign,
    number: (made.interval ? `(${both})` : both) + power };
}

/// "243 ± 16 mW".
export function quantityText(quantity) {
  const { number, unit } = parts(quantity);
  return unit === "" || unit === "°" ? number + unit : `${number}\u00a0${unit}`;
}

function exponential(number) {
  const [digits, power] = number.toExponential(1).split("e");
  return `${digits} × ${powerOfTen(Number(power))}`;
}

/// "12 345" with a narrow no-break space between thousands.
export const grouped = (number) => String(number).replace(/\B(?=(\d{3})+$)/g, "\u202f");

/// About three digits, for axes and short texts.
export const short = (number) =>
  Math.abs(number) >= 1e5 || (number !== 0 && Math.abs(number) < 1e-3)
    ? exponential(number) : String(Number(number.toPrecision(3)));

/// A number with a prefix of the unit, for axes: "20 mW".
export function scaledText(number, unit) {
  const m = multiple(Math.abs(number), unit), sign = signs[m.unit] ?? m.unit;
  return `${short(Number((number / m.factor).toPrecision(3)))}${sign ? ` ${sign}` : ""}`;
}
