// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The spectrum: rate of collisions over impact energy, or the power that they carry.

import { choice } from "../dom.js";
import { columnOf } from "../csv.js";
import { scaledText, short } from "../format.js";
import { text } from "../text/en.js";
import { Plot } from "./plot.js";

const kinds = { rate: "rate_normal_per_s", power: "power_normal_W" };
const octaves = 0.5; // width of a bin of the plot

/// Curve over bins of half an octave, which are wide enough for short runs: a Map from the number of
/// the bin to the sum in it.
function binned(table, column) {
  const lows = columnOf(table, "energy_low_J");
  const values = columnOf(table, column);
  const bins = new Map();
  lows?.forEach((low, i) => {
    if (!(values[i] > 0)) return;
    const bin = Math.floor(Math.log2(low * 1.0001) / octaves);
    bins.set(bin, (bins.get(bin) ?? 0) + values[i] / octaves);
  });
  return bins;
}

/// Bins from the first to the last that hold more than a ten-thousandth of the largest.
function span(all) {
  const numbers = all.flatMap((bins) => {
    const most = Math.max(...bins.values());
    return [...bins].filter(([, value]) => value > 1e-4 * most).map(([bin]) => bin);
  });
  const [low, high] = [Math.min(...numbers), Math.max(...numbers)];
  return Array.from({ length: high - low + 3 }, (_, i) => low - 1 + i);
}

export class SpectrumPlot {
  constructor() {
    this.plot = new Plot(text.spectrum);
    this.kind = "rate";
    this.plot.tools.append(choice(text.spectrumOf, [
      { key: "rate", name: text.rate, about: text.spectrumRateAbout },
      { key: "power", name: text.power, about: text.spectrumPowerAbout },
    ], "rate", (kind) => {
      this.kind = kind;
      this.draw();
    }));
    this.root = this.plot.root;
  }

  /// `kept`: the spectrum of the kept result, or null.
  show(table, kept = null) {
    this.tables = [table, kept];
    this.draw();
  }

  draw() {
    const [table, kept] = this.tables ?? [];
    if (!table) return this.plot.clear();
    const tables = kept ? [table, kept] : [table];
    const curves = tables.map((each) => binned(each, kinds[this.kind]));
    if (curves[0].size === 0) return this.plot.clear();
    const bins = span(curves.filter((curve) => curve.size > 0));
    const xs = bins.map((bin) => 2 ** (bin * octaves));
    const rate = this.kind === "rate";
    const data = [xs, ...curves.map((curve) => bins.map((bin) => curve.get(bin) ?? (rate ? null : 0)))];
    const most = Math.max(...curves.flatMap((curve) => [...curve.values()]));
    const peak = xs[data[1].indexOf(Math.max(...data[1]))];
    this.plot.show({ data,
      x: { label: text.impactEnergy, log: true, values: (at) => scaledText(at, "J") },
      y: { label: rate ? text.rateAxis : text.powerPerOctave, wide: 64, log: rate,
        range: rate ? [10 ** Math.floor(Math.log10(2e-4 * most)), 2 ** Math.ceil(Math.log2(1.2 * most))] : null,
        values: (at) => (rate ? short(at) : scaledText(at, "W")) },
      series: [{ label: kept ? "B" : text.thisRun, colour: "go", steps: true, fill: true },
        ...(kept ? [{ label: "A", colour: "kept", steps: true, dash: [5, 4] }] : [])],
      about: text.spectrumAbout(scaledText(peak, "J")) });
  }
}
