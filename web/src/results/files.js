// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Files of a finished result, and the way to open others.

import { button, download, element } from "../dom.js";
import { text } from "../text/text.js";

const types = { json: "application/json", html: "text/html", csv: "text/csv", toml: "application/toml" };
const order = ["report.html", "summary.json", "case.resolved.toml"];
const rank = (name) => (order.includes(name) ? order.indexOf(name) : order.length);

export const typeOf = (name) => types[name.split(".").pop()] ?? "text/plain";

export class Files {
  /// `caseText()` returns the text of the case; `open(files)` shows another result.
  constructor(root, { caseText, open }) {
    this.root = root;
    this.caseText = caseText;
    this.input = element("input", { type: "file", multiple: true, accept: ".json,.csv,.toml,.html", hidden: true,
      onchange: () => open(this.input.files) });
    this.show(null);
  }

  show(files) {
    const names = Object.keys(files ?? {}).sort((a, b) => rank(a) - rank(b) || a.localeCompare(b));
    const save = (name, content) =>
      button(name, () => download(name, content(), typeOf(name)), { className: "file" });
    this.root.replaceChildren(
      element("p", { className: "note", textContent: files ? text.filesAbout : text.filesHint }),
      element("div", { className: "row" }, button(text.openResult, () => this.input.click(), { className: "quiet" }), this.input),
      element("p", { className: "note", textContent: text.openAbout }),
      element("div", { className: "files" }, save("case.toml", this.caseText),
        names.map((name) => save(name, () => files[name]))));
  }
}
