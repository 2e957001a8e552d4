// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Dissipated power over simulated time, and its mean so far, which settles while the run goes on.

import { columnOf } from "../csv.js";
import { scaledText, short } from "../format.js";
import { text } from "../text/en.js";
import { Plot } from "./plot.js";

/// Mean from the start to each time; each value holds since the time before.
function meansSoFar(times, values) {
  const before = (i) => (i > 0 ? times[i - 1] : 0);
  let sum = 0;
  return values.map((value, i) => {
    sum += value * (times[i] - before(i));
    return sum / times[i];
  });
}

export class SeriesPlot {
  constructor() {
    this.plot = new Plot(text.powerOverTime);
    this.root = this.plot.root;
  }

  /// `table`: timeseries, or null.
  show(table) {
    const times = table && columnOf(table, "time_s");
    if (!times || times.length < 2) return this.plot.clear();
    const dissipated = columnOf(table, "dissipated_power_W");
    this.plot.show({ data: [times, dissipated, meansSoFar(times, dissipated)],
      x: { label: text.timeAxis, values: short },
      y: { label: text.powerAxis, wide: 64, values: (at) => scaledText(at, "W") },
      series: [{ label: text.dissipated, colour: "faint", width: 1 },
        { label: text.meanSoFar, colour: "go", width: 2.2 }],
      about: text.seriesAbout(times.length) });
  }
}
