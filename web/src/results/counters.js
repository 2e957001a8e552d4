// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The large numbers at the top of a result.

import { element } from "../dom.js";
import { grouped, parts } from "../format.js";
import { text } from "../text/text.js";

const blank = { value: "–", interval: "", unit: "" };

export class Counters {
  constructor(root) {
    this.cells = Object.fromEntries(["collisions", "simulated", "power", "rate"].map((key) => {
      const value = element("span", { className: "value" });
      const interval = element("span", { className: "interval" });
      const box = element("div", { className: "counter" },
        element("dt", { textContent: text.counter(key) }), element("dd", {}, value, interval));
      box.dataset.key = key;
      return [key, { box, value, interval }];
    }));
    root.append(...Object.values(this.cells).map(({ box }) => box));
  }

  set(key, { value, interval, unit }) {
    const cell = this.cells[key];
    cell.value.textContent = unit ? `${value}\u00a0${unit}` : value;
    cell.interval.textContent = interval ? `± ${interval}${unit ? `\u00a0${unit}` : ""}` : "";
  }

  /// Numbers of a run; without one, blanks.
  show(run) {
    if (!run) return Object.keys(this.cells).forEach((key) => this.set(key, blank));
    const quantities = run.quantities();
    this.set("collisions", { ...blank, value: grouped(run.sum("collisions")) });
    const simulated = run.sum("simulated");
    this.set("simulated", { ...parts({ value: Number(simulated.toPrecision(4)), unit: "s" }),
      interval: "" });
    this.set("power", quantities ? parts(quantities.dissipated_power) : blank);
    this.set("rate", quantities ? parts(quantities.collision_rate_above_threshold) : blank);
  }
}
