// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Invented numbers: a summary, tables and a report.

/// Random numbers from 0 to 1, the same for the same seed.
function random(seed) {
  let state = (seed * 2654435761 + 12345) >>> 0;
  return () => {
    state = (state * 1664525 + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function normal(draw) {
  return Math.sqrt(-2 * Math.log(draw() + 1e-12)) * Math.cos(2 * Math.PI * draw());
}

const powerOf = ({ drive, restitution }) => 4e-5 * drive ** 3 * (1.2 - restitution);
const energyOf = ({ drive }) => 1e-5 * drive ** 2;

/// Labels as those of most quantities: their names in words.
const labelled = (summary) => Object.fromEntries(Object.entries(summary).map(([key, value]) =>
  [key, key.startsWith("_") ? value : { label: key.replaceAll("_", " "), ...value }]));

export function summaryOf(settings, simulated, replicate, notices) {
  const scatter = 0.3 / Math.sqrt(Math.max(simulated, 1e-3));
  const draw = random(replicate + 1 + Math.round(simulated * 10));
  const quantity = (value, unit, about) => ({ value: value * (1 + 0.3 * scatter * normal(draw)),
    ci95: value * scatter, ci95_time: value * scatter, unit, about });
  return labelled({
    _about: { mahlwerk: "0.1.0", schema: 2, title: settings.title, engine: settings.engine, notices,
      complete: true },
    _key_quantities: ["dissipated_power", "collision_rate_above_threshold",
      "energy_normal_mean_above_threshold"],
    _groups: [{ heading: "Collisions", quantities: ["collision_rate", "collision_rate_above_threshold",
      "energy_normal_mean_above_threshold"] },
    { heading: "Power and contacts", quantities: ["dissipated_power", "drawn_power",
      "contact_time_share", "deepest_overlap", "simulated_time"] }],
    collision_rate: quantity(151, "1/s", "collisions per second, all of them"),
    collision_rate_above_threshold: quantity(145, "1/s",
      "collisions per second with a normal speed u_n of at least the threshold"),
    energy_normal_mean_above_threshold: quantity(energyOf(settings), "J",
      "mean impact energy of the normal motion, m u_n^2/2; collisions above the threshold"),
    dissipated_power: quantity(powerOf(settings), "W",
      "power dissipated in collisions and sustained contacts together"),
    drawn_power: quantity(powerOf(settings), "W", "work of the jar on the balls per time"),
    contact_time_share: quantity(0.07, "1", "share of the balls' time spent in sustained contact"),
    deepest_overlap: { value: 1e-12, ci95: null, ci95_time: null, unit: "1", about: "deepest overlap" },
    simulated_time: { value: simulated, ci95: null, ci95_time: null, unit: "s", about: "simulated time" },
  });
}

export function spectrumOf(settings, simulated, replicate) {
  const draw = random(7 * replicate + 3);
  const middle = Math.log2(energyOf(settings));
  const hits = Math.max(40, Math.round(simulated * 145));
  const bins = new Map();
  for (let i = 0; i < Math.min(hits, 6000); ++i) {
    const bin = Math.floor(4 * (middle + 1.6 * normal(draw)));
    bins.set(bin, (bins.get(bin) ?? 0) + 145 / Math.min(hits, 6000));
  }
  const rows = [...bins].sort((a, b) => a[0] - b[0]).map(([bin, rate]) => {
    const [low, high] = [2 ** (bin / 4), 2 ** ((bin + 1) / 4)];
    return [low, high, rate, rate * Math.sqrt(low * high)].join(",");
  });
  return `energy_low_J,energy_high_J,rate_normal_per_s,power_normal_W\n${rows.join("\n")}\n`;
}

export function timeseriesOf(settings, simulated, replicate) {
  const draw = random(replicate + 11);
  const total = settings.time + settings.settle;
  const rows = [];
  for (let time = total / 200; time <= simulated; time += total / 200) {
    const power = powerOf(settings) * (1 + 0.15 * normal(draw));
    rows.push([time, 151, power, power * (1 + 0.1 * normal(draw))].join(","));
  }
  return `time_s,collision_rate_per_s,dissipated_power_W,drawn_power_W\n${rows.join("\n")}\n`;
}

const share = (size, middle) => 1 - Math.exp(-((size / middle) ** 1.2));

export function sizesOf({ powder }) {
  if (!powder) return "";
  const rows = [];
  for (let minute = 0; minute <= 60; minute += 5)
    for (let size = 1e-6; size < 1e-3; size *= 1.3)
      rows.push([60 * minute, size, size * 1.3, 0, 0, share(size * 1.3, 3e-4 / (1 + minute / 4))].join(","));
  return `time_s,size_low_m,size_high_m,share,density,passing\n${rows.join("\n")}\n`;
}

export function grindingOf({ powder }) {
  if (!powder) return "";
  const rows = Array.from({ length: 61 }, (_, minute) => {
    const middle = 3e-4 / (1 + minute / 4);
    return [60 * minute, 0.2 * middle, 0.7 * middle, 2 * middle].join(",");
  });
  return `time_s,d10_m,d50_m,d90_m\n${rows.join("\n")}\n`;
}

const escaped = (text) => text.replace(/[&<>"]/g, (c) => `&#${c.codePointAt(0)};`);

export const reportOf = ({ title }) => `<!doctype html><html lang="en"><head><meta charset="utf-8">
<title>${escaped(title)}</title><style>h1 { color: rgb(1, 2, 3) }</style></head>
<body><h1>${escaped(title)}</h1><p id="ran">no</p>
<script>document.getElementById("ran").textContent = "script ran";</script></body></html>
`;
