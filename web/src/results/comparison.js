// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Two results side by side: A is chosen, B is chosen or the newest.

import { button, element, freshId } from "../dom.js";
import { quantityText } from "../format.js";
import { differences } from "../case/toml_text.js";
import { quantityName, text } from "../text/text.js";
import { verdictOf } from "./verdict.js";
import { shortList } from "./quantities.js";
import { SpectrumPlot } from "./spectrum_plot.js";

function changeOf(a, b) {
  if (a.value === 0) return "";
  const percent = 100 * (b.value / a.value - 1);
  const size = Number(Math.abs(percent).toPrecision(2));
  return `${percent < 0 ? "−" : "+"}${size < 0.1 ? 0 : size}\u00a0%`;
}

export class Comparison {
  /// `keep()` returns the newest result { id, title, toml, summary, spectrum } or null. `changed` is called when A
  /// changes, `restore(toml)` to take its case again. `history`: the results that can be chosen.
  constructor(root, { keep, changed, restore, history }) {
    Object.assign(this, { keep, changed, restore, history });
    this.kept = null; // A
    this.other = null; // B, if it is chosen
    this.about = element("p", { className: "note" });
    this.keepButton = button(text.keepAsA, () => this.take(this.keep()));
    this.forgetButton = button(text.forgetA, () => this.take(null), { className: "quiet" });
    this.restoreButton = button(text.restoreA, () => this.restore(this.kept.toml), { className: "quiet" });
    this.sides = Object.fromEntries(["a", "b"].map((side) => [side, element("select", { id: freshId("side"),
      onchange: ({ target }) => this.choose(side, target.value || null) })]));
    this.box = element("div", { className: "scroll", tabIndex: 0, role: "region", "aria-label": text.comparison });
    this.spectrum = new SpectrumPlot();
    root.append(element("div", { className: "fields sides" }, ...Object.entries(this.sides).map(([side, select]) =>
      element("div", { className: "field" }, element("label", { for: select.id, textContent: side.toUpperCase() }), select))),
    element("div", { className: "row" }, this.keepButton, this.restoreButton, this.forgetButton), this.about, this.box,
    this.spectrum.root);
    history.addEventListener("change", () => this.draw());
    this.draw();
  }

  /// Takes an entry of the history as A or B; null: none, or the newest result.
  choose(side, id) {
    const result = id && this.history.resultOf(id);
    if (side === "a") return this.take(result);
    this.other = result;
    return this.draw();
  }

  take(result) {
    this.kept = result;
    this.draw();
    this.changed();
  }

  /// An entry of the history is deleted.
  removed(id) {
    if (this.other?.id === id) this.choose("b", null);
    if (this.kept?.id === id) this.take(null);
  }

  /// Ids of what is chosen, or null.
  chosen() {
    return { a: this.kept?.id ?? null, b: this.other?.id ?? null };
  }

  /// The newest result, unless it is A.
  newest() {
    const result = this.keep();
    return result && result.id !== this.kept?.id ? result : null;
  }

  /// Called again when there is another newest result.
  draw() {
    const { kept } = this, b = this.other ?? this.newest();
    this.offer();
    this.keepButton.disabled = !this.keep();
    this.forgetButton.hidden = this.restoreButton.hidden = !kept;
    this.about.textContent = !kept ? text.compareHint
      : b ? text.compareAbout(kept.title, b.title) + text.differences(differences(kept.toml, b.toml))
        : text.compareRunB(kept.title);
    this.spectrum.root.hidden = !(kept?.spectrum && b?.spectrum);
    if (!this.spectrum.root.hidden) this.spectrum.show(b.spectrum, kept.spectrum);
    this.box.replaceChildren(...(kept && b ? [this.table(kept.summary, b.summary)] : []));
  }

  /// The choices of A and B.
  offer() {
    const entries = this.history.entries.filter(({ summary }) => summary);
    for (const [side, first, chosen] of [["a", text.noA, this.kept], ["b", text.newestAsB, this.other]]) {
      const id = chosen?.id;
      const options = [{ value: "", name: first }, ...entries.map((entry) =>
        ({ value: entry.id, name: text.entryChoice(entry) }))];
      if (id && !this.history.of(id)) options.push({ value: id, name: chosen.title }); // it is older than the history
      this.sides[side].replaceChildren(...options.map(({ value, name }) =>
        element("option", { value, textContent: name })));
      this.sides[side].value = id ?? "";
    }
  }

  table(a, b) {
    const keys = shortList(a).filter((key) => Number.isFinite(b[key]?.value));
    return element("table", { className: "comparison" },
      element("thead", {}, element("tr", {}, ...text.compareColumns.map((name) =>
        element("th", { scope: "col", textContent: name })))),
      element("tbody", {}, keys.map((key) => {
        const verdict = verdictOf(a[key], b[key]);
        return element("tr", { className: verdict },
          element("th", { scope: "row", textContent: quantityName(key, a[key]) }),
          element("td", { className: "figure", textContent: quantityText(a[key]) }),
          element("td", { className: "figure", textContent: quantityText(b[key]) }),
          element("td", { className: "figure", textContent: changeOf(a[key], b[key]) }),
          element("td", { className: "verdict", textContent: text.verdict(verdict) }));
      })));
  }
}
