// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The report of the program: every plot, map and panel of a result, as `mahlwerk run` writes them.

import { element } from "../dom.js";
import { text } from "../text/text.js";

/// A report has scripts of its own. It is shown in a page with another policy, in a frame that may run scripts, but has
/// no access to this page, to its storage or to the network. The frame loads when it is seen.
export class ReportPanel {
  constructor(root) {
    this.root = root;
    this.html = null;
    addEventListener("message", ({ source, data }) => {
      if (data === "ready" && source && source === this.frame?.contentWindow) source.postMessage(this.html, "*");
    });
    this.show(null);
  }

  show(html) {
    if (html && html === this.html) return;
    this.html = html;
    this.frame = html ? element("iframe", { title: text.report, loading: "lazy", src: "report_frame.html" }) : null;
    this.frame?.sandbox.add("allow-scripts", "allow-downloads");
    this.root.replaceChildren(this.frame ?? element("p", { className: "empty", textContent: text.noReport }));
  }
}
