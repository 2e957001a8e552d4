// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Run, pause and stop, with the progress.

import { button, element } from "../dom.js";
import { text } from "../text/text.js";

export class RunBar {
  /// `actions`: run, pause, stop.
  constructor(root, actions) {
    this.run = button(text.run, actions.run, { className: "primary", id: "run" });
    this.pause = button(text.pause, actions.pause, { id: "pause", disabled: true });
    this.stop = button(text.stop, actions.stop, { id: "stop", disabled: true });
    this.progress = element("progress", { max: 1, value: 0, "aria-label": text.progress });
    this.status = element("span", { className: "status", id: "status" });
    this.said = element("span", { className: "for-readers", role: "status", "aria-live": "polite" });
    root.append(element("div", { className: "buttons" }, this.run, this.pause, this.stop),
      element("div", { className: "progress" }, this.progress, this.status, this.said));
  }

  /// An element beside the status.
  add(element) {
    this.status.after(element);
  }

  /// `run`: the current run or null; `ready`: whether a run can start.
  show(run, ready, note = "") {
    const status = run?.status ?? "none";
    const active = status === "computing" || status === "paused";
    this.run.disabled = !ready || active || ["stopping", "merging"].includes(status);
    this.pause.disabled = this.stop.disabled = !active;
    this.pause.textContent = status === "paused" ? text.resume : text.pause;
    this.progress.value = run ? run.share() : 0;
    this.progress.classList.toggle("idle", !run);
    this.status.textContent = note || text.status(run);
    document.body.dataset.run = status;
    this.say(status, run);
  }

  /// Screen readers hear a change of the status, and every quarter of the way.
  say(status, run) {
    const quarter = run ? Math.floor(run.share() * 4) : 0;
    const now = `${status} ${quarter}`;
    if (now === this.before) return;
    this.before = now;
    this.said.textContent = text.status(run);
  }
}
