// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Sizes of the powder over the milling time.

import { element } from "../dom.js";
import { columnOf } from "../csv.js";
import { short } from "../format.js";
import { text } from "../text/en.js";
import { line, pageChart } from "./page_chart.js";

/// The times of the table nearest to the start, the middle and the end.
function timesToShow(times) {
  const all = [...new Set(times)];
  const last = all.length - 1;
  const at = [0, Math.round(last * 0.1), Math.round(last * 0.4), last];
  return [...new Set(at)].map((i) => all[i]);
}

export const clock = (seconds) => seconds >= 3600 ? `${short(seconds / 3600)} h`
  : seconds >= 60 ? `${short(seconds / 60)} min` : `${short(seconds)} s`;

export class Powder {
  constructor(root) {
    this.hint = element("p", { className: "note", textContent: text.powderHint });
    this.passing = pageChart(text.passing);
    this.sizes = pageChart(text.sizesOverTime);
    this.plots = element("div", { className: "plots" }, this.passing.figure, this.sizes.figure);
    root.append(this.hint, this.plots);
    this.show(null, null);
  }

  /// `distribution`: table size_distribution; `grinding`: table grinding; or null.
  show(distribution, grinding) {
    const some = Boolean(distribution?.rows.length);
    this.hint.hidden = some;
    this.plots.hidden = !some;
    if (!some) return;
    this.showPassing(distribution);
    this.sizes.figure.hidden = !grinding?.rows.length;
    if (grinding?.rows.length) this.showSizes(grinding);
  }

  showPassing(table) {
    const times = columnOf(table, "time_s");
    const sizes = columnOf(table, "size_high_m");
    const passing = columnOf(table, "passing");
    const shown = timesToShow(times);
    const xs = [...new Set(sizes)].sort((a, b) => a - b);
    this.passing.show({ title: text.passing, shape: 0.64, x: { label: `${text.grainSize} (µm)`, log: true },
      y: { label: `${text.passingAxis} (%)`, log: false, least: 0, most: 100 },
      series: shown.map((time, i) => {
        const at = new Map();
        times.forEach((each, k) => each === time && at.set(sizes[k], 100 * passing[k]));
        return line(clock(time), xs.map((x) => 1e6 * x), xs.map((x) => at.get(x) ?? null), { colour: i });
      }) });
  }

  showSizes(table) {
    const minutes = columnOf(table, "time_s").map((time) => time / 60);
    const series = ["d10", "d50", "d90"].map((name, i) => line(name.toUpperCase(), minutes,
      columnOf(table, `${name}_m`).map((size) => (size > 0 ? 1e6 * size : null)), { colour: i }));
    this.sizes.show({ title: text.sizesOverTime, shape: 0.64, x: { label: text.millingTime, log: false },
      y: { label: `${text.grainSize} (µm)`, log: true }, series });
  }
}
