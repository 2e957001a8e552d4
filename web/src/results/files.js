// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Files of a finished result: downloads, and the report in a dialog.

import { button, download, element } from "../dom.js";
import { text } from "../text/en.js";

const types = { json: "application/json", html: "text/html", csv: "text/csv", toml: "application/toml" };
const order = ["report.html", "summary.json", "case.resolved.toml"];
const rank = (name) => (order.includes(name) ? order.indexOf(name) : order.length);

export const typeOf = (name) => types[name.split(".").pop()] ?? "text/plain";

/// A report has scripts of its own. It is shown in a page with another policy, in a frame that may
/// run scripts, but has no access to this page, to its storage or to the network.
export function openReport(html) {
  const frame = element("iframe", { title: text.report, src: "report_frame.html" });
  frame.sandbox.add("allow-scripts", "allow-downloads");
  const fill = ({ source, data }) => {
    if (source === frame.contentWindow && data === "ready") source.postMessage(html, "*");
  };
  addEventListener("message", fill);
  const close = button(text.close, () => dialog.close(), { className: "primary" });
  const dialog = element("dialog", { className: "report", "aria-label": text.report },
    element("div", { className: "bar" }, element("strong", { textContent: text.report }), close), frame);
  dialog.addEventListener("close", () => {
    removeEventListener("message", fill);
    dialog.remove();
  });
  document.body.append(dialog);
  dialog.showModal();
}

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
      element("div", { className: "row" }, files?.["report.html"]
        ? button(text.openReport, () => openReport(files["report.html"]), { className: "primary" })
        : null, button(text.openResult, () => this.input.click(), { className: "quiet" }), this.input),
      element("p", { className: "note", textContent: text.openAbout }),
      element("div", { className: "files" }, save("case.toml", this.caseText),
        names.map((name) => save(name, () => files[name]))));
  }
}
