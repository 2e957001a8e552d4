// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Dissipated power over simulated time, and its mean so far, which settles while the run goes on.

import { columnOf } from "../csv.js";
import { multipleOf } from "../format.js";
import { text } from "../text/text.js";
import { line, pageChart } from "./page_chart.js";

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
    this.chart = pageChart(text.powerOverTime);
    this.root = this.chart.figure;
  }

  /// `table`: timeseries, or null.
  show(table) {
    const times = table && columnOf(table, "time_s");
    if (!times || times.length < 2) return this.chart.clear();
    const dissipated = columnOf(table, "dissipated_power_W");
    const { factor, unit } = multipleOf(Math.max(...dissipated), "W");
    const scaled = (values) => values.map((value) => value / factor);
    this.chart.show({ title: text.powerOverTime, shape: 0.64, x: { label: text.timeAxis, log: false },
      y: { label: `${text.powerAxis} (${unit})`, log: false }, series: [
        line(text.dissipated, times, scaled(dissipated), { colour: 5 }),
        line(text.meanSoFar, times, scaled(meansSoFar(times, dissipated)))] });
  }
}
