// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The spectrum: rate of collisions over impact energy, or the power that they carry.

import { choice } from "../dom.js";
import { columnOf } from "../csv.js";
import { multipleOf, scaledText } from "../format.js";
import { text } from "../text/text.js";
import { pageChart } from "./page_chart.js";

const kinds = { rate: "rate_normal_per_s", power: "power_normal_W" };
const octaves = 0.5; // width of a bin of the plot

/// Curve over bins of half an octave, which are wide enough for short runs: a Map from the number of
/// the bin to the sum in it.
function binned(table, column) {
  const lows = columnOf(table, "energy_low_J");
  const values = columnOf(table, column);
  const bins = new Map();
  lows?.forEach((low, i) => {
    if (!(values[i] > 0 && low > 0)) return; // the lowest bin begins at 0
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

const histogram = (name, bins, curve, colour, scale) => ({ name, mark: "steps", colour, band: false,
  x: [...bins, bins.at(-1) + 1].map((bin) => 2 ** (bin * octaves) / scale.x),
  y: bins.map((bin) => (curve.get(bin) ?? 0) / scale.y) });

export class SpectrumPlot {
  constructor() {
    this.kind = "rate";
    this.chart = pageChart(text.spectrum, choice(text.spectrumOf, [
      { key: "rate", name: text.rate, about: text.spectrumRateAbout },
      { key: "power", name: text.power, about: text.spectrumPowerAbout },
    ], "rate", (kind) => {
      this.kind = kind;
      this.draw();
    }));
    this.root = this.chart.figure;
  }

  /// `kept`: the spectrum of the kept result, or null.
  show(table, kept = null) {
    this.tables = [table, kept];
    this.draw();
  }

  draw() {
    const [table, kept] = this.tables ?? [];
    if (!table) return this.chart.clear();
    const curves = (kept ? [table, kept] : [table]).map((each) => binned(each, kinds[this.kind]));
    if (curves[0].size === 0) return this.chart.clear();
    const bins = span(curves.filter((curve) => curve.size > 0));
    const rate = this.kind === "rate";
    const most = Math.max(...curves.flatMap((curve) => [...curve.values()]));
    const energy = multipleOf(2 ** (bins.at(-1) * octaves), "J"), power = rate ? { factor: 1 } : multipleOf(most, "W");
    const scale = { x: energy.factor, y: power.factor };
    this.chart.show({ title: text.spectrum, shape: 0.64,
      x: { label: `${text.impactEnergy} (${energy.unit})`, log: true },
      y: rate ? { label: text.rateAxis, log: true, least: 2e-4 * most }
        : { label: `${text.powerPerOctave} (${power.unit})`, log: false },
      series: curves.map((curve, i) => histogram(kept ? "BA"[i] : text.thisRun, bins, curve, i, scale)) });
    this.chart.canvas.title = text.spectrumAbout(scaledText(this.peak(curves[0]), "J"));
  }

  /// [J] The energy of the largest bin.
  peak(curve) {
    const [bin] = [...curve].reduce((a, b) => (b[1] > a[1] ? b : a));
    return 2 ** (bin * octaves);
  }
}
