// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The 3-D replay of the report, in the page: first the balls at the start, then newer and newer data.

import { readObject } from "../../../viewer/src/data.js";
import { mount } from "../../../viewer/src/replay.js";
import { text } from "../text/text.js";
import { onTheme } from "../theme.js";

const patience = 1500; // ms; the picture is set up after the first result, or then at the latest
const share = 6; // newer data come at most at this multiple of the time that it takes to show them

export class ReplayPanel {
  constructor(root) {
    this.root = root;
    this.replay = null;
    this.quietUntil = 0;
    root.classList.add("waiting");
    onTheme(() => this.replay?.repaint());
  }

  /// Shows data soon. `restart`: they are of another case.
  show(film, restart) {
    if (!film || this.impossible) return;
    this.next = { film, restart: restart || (this.next?.restart ?? false) };
    if (this.timer && !(restart && this.replay)) return;
    clearTimeout(this.timer);
    this.wait(!this.replay ? patience : restart ? 0 : this.quietUntil - performance.now());
  }

  wait(milliseconds) {
    this.timer = setTimeout(() => requestAnimationFrame(() => this.take()), Math.max(milliseconds, 0));
  }

  /// A result is complete: what waits is shown now.
  hurry() {
    if (!this.timer || this.replay) return;
    clearTimeout(this.timer);
    this.wait(60);
  }

  take() {
    if (!this.next) return;
    const { film, restart } = this.next;
    this.next = this.timer = null;
    const begun = performance.now();
    if (!this.replay) return this.mount(film);
    this.renew(film, restart);
    const now = performance.now();
    this.quietUntil = now + Math.min(share * (now - begun), patience);
  }

  mount(film) {
    this.root.classList.remove("waiting");
    this.replay = mount(this.root, () => readObject(film), text.replayWords);
    this.impossible = !this.replay;
  }

  renew(film, restart) {
    try {
      this.replay.renew(readObject(film), restart);
    } catch (error) {
      this.root.dataset.error = error.message;
    }
  }
}
