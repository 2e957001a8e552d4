// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Sizes of the powder over the milling time.

import { element } from "../dom.js";
import { columnOf } from "../csv.js";
import { scaledText, short } from "../format.js";
import { text } from "../text/en.js";
import { Plot } from "./plot.js";

const colours = ["faint", "kept", "soft", "go"];

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
    this.passing = new Plot(text.passing);
    this.sizes = new Plot(text.sizesOverTime);
    this.plots = element("div", { className: "plots" }, this.passing.root, this.sizes.root);
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
    this.sizes.root.hidden = !grinding?.rows.length;
    if (grinding?.rows.length) this.showSizes(grinding);
  }

  showPassing(table) {
    const times = columnOf(table, "time_s");
    const sizes = columnOf(table, "size_high_m");
    const passing = columnOf(table, "passing");
    const shown = timesToShow(times);
    const xs = [...new Set(sizes)].sort((a, b) => a - b);
    const columns = shown.map((time) => {
      const at = new Map();
      times.forEach((each, i) => each === time && at.set(sizes[i], 100 * passing[i]));
      return xs.map((x) => at.get(x) ?? null);
    });
    this.passing.show({ data: [xs, ...columns],
      x: { label: text.grainSize, log: true, values: (at) => scaledText(at, "m") },
      y: { label: text.passingAxis, range: [0, 100], values: (at) => `${short(at)} %` },
      series: shown.map((time, i) => ({ label: clock(time),
        colour: colours[colours.length - shown.length + i] })),
      about: text.passingAbout(shown.map(clock)) });
  }

  showSizes(table) {
    const column = (name) => columnOf(table, name).map((size) => (size > 0 ? size : null));
    this.sizes.show({ data: [columnOf(table, "time_s").map((time) => time / 60), column("d10_m"),
      column("d50_m"), column("d90_m")],
      x: { label: text.millingTime, values: short },
      y: { label: text.grainSize, log: true, values: (at) => scaledText(at, "m"), wide: 64 },
      series: [{ label: "D10", colour: "kept", dash: [5, 4] }, { label: "D50", colour: "go" },
        { label: "D90", colour: "soft", dash: [2, 3] }], about: text.sizesAbout });
  }
}
