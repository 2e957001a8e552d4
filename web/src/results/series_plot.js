// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Power and rate over simulated time.

import { columnOf } from "../csv.js";
import { scaledText, short } from "../format.js";
import { text } from "../text/en.js";
import { Plot } from "./plot.js";

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
    const drawn = columnOf(table, "drawn_power_W");
    this.plot.show({ data: [times, dissipated, drawn],
      x: { label: text.timeAxis, values: short },
      y: { label: text.powerAxis.split(",")[0], wide: 64, values: (at) => scaledText(at, "W") },
      series: [{ label: text.dissipated, colour: "go" },
        { label: text.drawn, colour: "kept", width: 1.2, dash: [5, 4] }],
      about: text.seriesAbout(times.length) });
  }
}
