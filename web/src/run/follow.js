// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// "Run follows changes": a changed case takes the place of the one that is computed.

import { element, later } from "../dom.js";
import { text } from "../text/text.js";
import { Run } from "./run.js";

const key = "mahlwerk-follow";
const pause = 300; // ms without a change, after which the run starts anew
const quick = 30; // s; after its end, only a run that took no longer is computed anew unasked

function stored() {
  try {
    return localStorage.getItem(key) !== "off";
  } catch {
    return true; // pages from disk may have no storage
  }
}

function store(on) {
  try {
    localStorage.setItem(key, on ? "on" : "off");
  } catch {
    // the choice holds until the page is closed
  }
}

export class Follow {
  /// `page`: { store, run, sweeping, restart() }.
  constructor(page) {
    this.page = page;
    this.input = element("input", { type: "checkbox", id: "follow", checked: stored(),
      onchange: () => (store(this.input.checked), this.changed()) });
    this.root = element("label", { className: "follow", title: text.followAbout }, this.input,
      element("span", { textContent: text.follow }));
    this.soon = later(() => this.act(), pause);
  }

  /// Whether a changed case is computed by itself: while another one is computed, and after a quick run that ended
  /// here. Not after Pause, Stop or a failure, and not for a result that was opened.
  wanted() {
    const { run, sweeping } = this.page;
    if (!this.input.checked || sweeping || !(run instanceof Run)) return false;
    return ["computing", "merging"].includes(run.status) || (run.status === "done" && run.seconds <= quick);
  }

  /// The case has changed.
  changed() {
    if (this.wanted()) this.soon();
  }

  async act() {
    if (this.acting || !this.wanted() || this.page.run.toml === this.page.store.text) return;
    this.acting = true;
    try {
      const { faults } = await this.page.store.check();
      if (faults.length === 0 && this.wanted()) await this.page.restart();
    } finally {
      this.acting = false;
    }
    if (this.page.run && this.page.run.toml !== this.page.store.text) this.changed();
  }
}
