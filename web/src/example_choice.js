// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The choice of an example, with a sentence on what to try.

import { element, freshId } from "./dom.js";
import { text } from "./text/text.js";

export class ExampleChoice {
  /// `cases`: texts of the examples by name. `choose(name)` is called when the reader picks one.
  constructor(root, cases, choose) {
    this.cases = cases;
    const id = freshId("example");
    this.select = element("select", { id, onchange: () => choose(this.select.value) }, Object.keys(cases).map((name) =>
      element("option", { value: name, textContent: text.exampleCases[name]?.name ?? name })));
    this.own = element("option", { value: "", textContent: text.ownCase, hidden: true });
    this.select.append(this.own);
    this.hint = element("p", { className: "note hint" });
    root.append(element("div", { className: "field wide" },
      element("label", { for: id, textContent: text.example }), this.select), this.hint);
  }

  /// Shows which example the case comes from; "": from none.
  show(name) {
    this.name = name;
    this.own.hidden = name !== "";
    this.select.value = name;
    this.hint.textContent = text.exampleCases[name]?.hint ?? "";
    this.hint.hidden = !this.hint.textContent;
  }
}
