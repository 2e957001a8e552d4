// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The case: its text, and what the engine says about it. Form and editor both change the text.

import { later } from "../dom.js";
import { parse, write } from "./toml_text.js";

/// The text as the page keeps it: lines end with \n, and no character ends the text early.
export const kept = (text) => text.replace(/\r\n?/g, "\n").replaceAll("\0", "\uFFFD");

export class CaseStore extends EventTarget {
  /// `inspector`: the worker that checks.
  constructor(inspector) {
    super();
    this.inspector = inspector;
    this.text = "";
    this.sections = [];
    this.checked = null;
    this.revision = 0;
    this.checkSoon = later(() => this.check(), 200);
  }

  /// `from`: who changes the text ("form", "editor", "choice"), for listeners that need not follow.
  setText(given, from) {
    const text = kept(given);
    if (text === this.text) return;
    this.text = text;
    this.sections = parse(text);
    ++this.revision;
    this.dispatchEvent(new CustomEvent("text", { detail: { from } }));
    if (from === "choice") this.check();
    else this.checkSoon();
  }

  setValue(address, value, from = "form") {
    this.setText(write(this.text, address, value), from);
  }

  /// The newest check; waits for it if the text has changed since.
  async check() {
    const revision = this.revision;
    if (this.checked?.revision === revision) return this.checked;
    let checked;
    try {
      checked = await this.inspector.call("check", this.text, []);
    } catch (error) {
      checked = { faults: [{ where: "", line: 0, column: 0, text: error.message, remedy: "",
        code: "internal" }], notices: [], origins: [], film: null };
      this.inspector.renew();
    }
    if (revision !== this.revision) return this.check();
    if (this.checked?.revision === revision) return this.checked;
    this.checked = { ...checked, revision };
    this.dispatchEvent(new CustomEvent("checked", { detail: this.checked }));
    return this.checked;
  }
}
