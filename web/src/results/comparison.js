// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Two results side by side: A is kept, B is the newest.

import { button, element } from "../dom.js";
import { quantityText } from "../format.js";
import { differences } from "../case/toml_text.js";
import { quantityName, text } from "../text/text.js";
import { verdictOf } from "./verdict.js";
import { shortList } from "./quantities.js";

function changeOf(a, b) {
  if (a.value === 0) return "";
  const percent = 100 * (b.value / a.value - 1);
  const size = Number(Math.abs(percent).toPrecision(2));
  return `${percent < 0 ? "−" : "+"}${size < 0.1 ? 0 : size}\u00a0%`;
}

export class Comparison {
  /// `keep()` returns the newest result { title, toml, summary, spectrum } or null. `changed` is called
  /// when A changes, `restore(toml)` to take its case again.
  constructor(root, keep, changed, restore) {
    Object.assign(this, { keep, changed, restore });
    this.kept = null;
    this.newest = null;
    this.about = element("p", { className: "note" });
    this.keepButton = button(text.keepAsA, () => this.take());
    this.forgetButton = button(text.forgetA, () => this.forget(), { className: "quiet" });
    this.restoreButton = button(text.restoreA, () => this.restore(this.kept.toml),
      { className: "quiet" });
    this.box = element("div", { className: "scroll", tabIndex: 0, role: "region",
      "aria-label": text.comparison });
    root.append(element("div", { className: "row" }, this.keepButton, this.restoreButton,
      this.forgetButton), this.about, this.box);
    this.draw();
  }

  take() {
    this.kept = this.keep();
    this.newest = null;
    this.draw();
    this.changed();
  }

  forget() {
    this.kept = null;
    this.draw();
    this.changed();
  }

  /// The newest finished result, or null.
  show(result) {
    this.newest = result;
    this.draw();
  }

  draw() {
    const { kept, newest } = this;
    this.keepButton.disabled = !this.keep();
    this.forgetButton.hidden = this.restoreButton.hidden = !kept;
    this.about.textContent = !kept ? text.compareHint
      : newest ? text.compareAbout(kept.title, newest.title) + text.differences(differences(kept.toml,
        newest.toml)) : text.compareRunB(kept.title);
    this.box.replaceChildren(...(kept && newest ? [this.table(kept.summary, newest.summary)] : []));
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
