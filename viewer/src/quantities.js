// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities of a ball that its colour can show: speed, spin and kinetic energy of translation.

const multiples = [[1, ""], [1e-3, "m"], [1e-6, "\u00b5"], [1e-9, "n"], [1e-12, "p"]];

/// The multiple of a unit for numbers up to `most`: `{ factor, unit }`.
export function multipleOf(most, unit) {
  const [factor, prefix] = multiples.find(([each]) => most >= 0.9995 * each) ?? multiples[0];
  return { factor, unit: prefix + unit };
}

const between = (list, { count }, { low, high, part }, ball) => {
  const from = list[count * low + ball];
  return from + part * (list[count * high + ball] - from);
};

/// [m/s] of a ball at a step between two frames; relative to the jar's centre.
export const speedAt = (data, step, ball) => data.speedScale * between(data.speeds, data, step, ball);

/// [rad/s]
export const spinAt = (data, step, ball) => data.spinScale * between(data.spins, data, step, ball);

/// [J] m v^2 / 2 with the speed relative to the jar's centre; without the spin.
export const energyAt = (data, step, ball) => 0.5 * data.masses[ball] * speedAt(data, step, ball) ** 2;

const known = { speed: () => true, spin: ({ spins }) => spins !== null, energy: ({ masses }) => masses !== null };
const valueOf = { speed: speedAt, spin: spinAt, energy: energyAt };
const units = { speed: "m/s", spin: "rad/s", energy: "J" };

/// What the colours of balls can show of these data: `key`, and the words.
export const coloursOf = (data, text) => [...Object.keys(known).filter((key) => known[key](data)), "species"]
  .map((key) => ({ key, ...text.colours[key] }));

/// The quantity of all balls as numbers from 0 to 1, the top of its scale: a round number that at most about 3 of
/// 1000 values exceed. `exceeded`: whether one does. `factor`, `unit`: those of the scale.
export function scaleOf(data, key) {
  const value = valueOf[key];
  const all = new Float32Array(data.frames * data.count);
  for (let f = 0; f < data.frames; ++f)
    for (let i = 0; i < data.count; ++i)
      all[f * data.count + i] = value(data, { low: f, high: f, part: 0 }, i);
  const most = all.reduce((a, b) => Math.max(a, b), 0);
  const common = most > 0 ? quantile(all, most, 0.997) : data.speedScale;
  const power = 10 ** Math.floor(Math.log10(common));
  const top = power * [1, 1.5, 2, 3, 4, 5, 6, 8, 10].find((step) => step * power >= 0.999 * common);
  return { top, exceeded: most > 1.001 * top, ...key === "energy" ? multipleOf(top, "J") : { factor: 1, unit: units[key] },
    at: (step, ball) => value(data, step, ball) / top };
}

/// The number that this share of all does not exceed, to a 65536th of the largest.
function quantile(all, most, share) {
  const bins = new Uint32Array(65536);
  for (const one of all) ++bins[Math.round((one / most) * 65535)];
  let above = (1 - share) * all.length;
  let at = bins.length - 1;
  while (at > 0 && (above -= bins[at]) >= 0) --at;
  return (Math.max(at, 1) / 65535) * most;
}
