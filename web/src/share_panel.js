// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// "Share": the link has been copied, and the text of a frame for other pages.

import { button, copied, element, freshId } from "./dom.js";
import { text } from "./text/text.js";

export class SharePanel {
  /// `share()` resolves with { said, frame }: what has been done, and the HTML of a frame.
  constructor(share) {
    this.button = button(text.share, () => this.open(share), { title: text.shareAbout, id: "share", "aria-expanded": "false" });
    this.said = element("p", { className: "said", role: "status" });
    const id = freshId("frame");
    this.frame = element("textarea", { id, readOnly: true, rows: 4, spellcheck: false, onfocus: () => this.frame.select() });
    this.copy = button(text.copy, () => this.copyFrame(), { id: "copy-frame" });
    this.root = element("section", { className: "share-panel", "aria-label": text.share, hidden: true,
      onkeydown: ({ key }) => void (key === "Escape" && this.close()) }, // false would stop every other key
    this.said, element("label", { for: id, textContent: text.embed }), this.frame,
    element("p", { className: "note", textContent: text.embedAbout }),
    element("div", { className: "row" }, this.copy, button(text.close, () => this.close(), { className: "quiet" })));
  }

  async open(share) {
    const { said, frame } = await share();
    this.root.hidden = false;
    this.button.setAttribute("aria-expanded", "true");
    this.frame.value = frame;
    this.copy.textContent = text.copy;
    this.said.textContent = said;
    this.copy.focus();
  }

  close() {
    this.root.hidden = true;
    this.said.textContent = "";
    this.button.setAttribute("aria-expanded", "false");
    this.button.focus();
  }

  async copyFrame() {
    this.frame.select();
    if (await copied(this.frame.value)) this.copy.textContent = text.copied;
    else this.frame.focus(); // selected, to be copied by the reader
  }
}
