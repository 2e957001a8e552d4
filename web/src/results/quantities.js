// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The table of all quantities of a result, with their intervals.

import { button, element } from "../dom.js";
import { quantityText } from "../format.js";
import { text } from "../text/en.js";

const first = ["dissipated_power", "drawn_power", "collision_rate_above_threshold", "collision_rate",
  "energy_normal_mean_above_threshold", "impact_speed_normal_mean_above_threshold",
  "impact_angle_mean_above_threshold", "tangential_impact_power", "contact_time_share", "d50",
  "specific_surface", "specific_energy_dose_rate", "stress_energy", "stress_number_rate"];

/// Keys of the quantities of a summary; the most asked for first.
export function keysIn(summary) {
  const keys = Object.keys(summary).filter((key) => key !== "_about" &&
    Number.isFinite(summary[key]?.value));
  return [...first.filter((key) => keys.includes(key)), ...keys.filter((key) => !first.includes(key))];
}

export const shortList = (keys) => keys.filter((key) => first.includes(key));

export class Quantities {
  constructor(root) {
    this.body = element("tbody");
    this.all = false;
    this.toggle = button(text.allQuantities, () => {
      this.all = !this.all;
      this.draw();
    }, { className: "quiet", "aria-expanded": "false" });
    this.preliminary = element("p", { className: "note", textContent: text.preliminary });
    root.append(this.preliminary, element("div", { className: "scroll", tabIndex: 0, role: "region",
      "aria-label": text.quantities }, element("table", { className: "quantities" },
      element("thead", {}, element("tr", {}, ...text.quantityColumns.map((name) =>
        element("th", { scope: "col", textContent: name })))), this.body)), this.toggle);
    this.show(null, false);
  }

  show(summary, preliminary) {
    this.summary = summary;
    this.preliminary.hidden = !preliminary;
    this.draw();
  }

  draw() {
    const keys = this.summary ? keysIn(this.summary) : [];
    const shown = this.all ? keys : shortList(keys);
    this.toggle.hidden = keys.length === 0;
    this.toggle.textContent = this.all ? text.fewQuantities : text.allQuantities;
    this.toggle.setAttribute("aria-expanded", String(this.all));
    if (keys.length === 0)
      return this.body.replaceChildren(element("tr", {},
        element("td", { colSpan: 3, className: "empty", textContent: text.noResult })));
    this.body.replaceChildren(...shown.map((key) => element("tr", {},
      element("th", { scope: "row", textContent: text.quantity(key) }),
      element("td", { className: "figure", textContent: quantityText(this.summary[key]) }),
      element("td", { className: "about", textContent: this.summary[key].about }))));
  }
}
