// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The key numbers of a result, and all its quantities in groups that can be folded.

import { element } from "../dom.js";
import { quantityText } from "../format.js";
import { groupName, quantityName, text } from "../text/text.js";

/// Keys of the quantities of a summary that have a number; the key numbers first.
export function keysIn(summary) {
  const keys = Object.keys(summary).filter((key) => !key.startsWith("_") &&
    Number.isFinite(summary[key]?.value));
  const first = shortList(summary);
  return [...first, ...keys.filter((key) => !first.includes(key))];
}

/// The key numbers of a summary that have a number.
export const shortList = (summary) =>
  summary._key_quantities.filter((key) => Number.isFinite(summary[key]?.value));

/// A dose without a milling time is named, not left out.
const withoutTime = (summary, key) =>
  key === "specific_energy_dose" && !Number.isFinite(summary[key].value);

export class Quantities {
  constructor(root) {
    this.folded = new Map(); // heading -> whether its group is open
    this.preliminary = element("p", { className: "note", textContent: text.preliminary });
    this.body = element("div");
    root.append(this.preliminary, this.body);
    this.show(null, false);
  }

  show(summary, preliminary) {
    this.summary = summary;
    this.preliminary.hidden = !preliminary;
    if (!summary)
      return this.body.replaceChildren(element("p", { className: "empty", textContent: text.noResult }));
    this.body.replaceChildren(this.table(summary._key_quantities),
      ...summary._groups.map((group) => this.group(group)));
  }

  /// Hidden if no quantity of the group is finite.
  group({ heading, quantities }) {
    const keys = quantities.filter((key) => Number.isFinite(this.summary[key].value));
    const group = element("details", { open: this.folded.get(heading) ?? false, hidden: keys.length === 0 },
      element("summary", { textContent: groupName(heading) }), this.table(keys));
    group.addEventListener("toggle", () => this.folded.set(heading, group.open));
    return group;
  }

  table(keys) {
    const rows = keys.map((key) => element("tr", {},
      element("th", { scope: "row", textContent: quantityName(key, this.summary[key]) }),
      element("td", { className: "figure", textContent: withoutTime(this.summary, key)
        ? text.noMillingTime : quantityText(this.summary[key]) }),
      element("td", { className: "about", textContent: this.summary[key].about })));
    return element("div", { className: "scroll", tabIndex: 0, role: "region",
      "aria-label": text.quantities }, element("table", { className: "quantities" },
      element("thead", {}, element("tr", {}, ...text.quantityColumns.map((name) =>
        element("th", { scope: "col", textContent: name })))), element("tbody", {}, ...rows)));
  }
}
