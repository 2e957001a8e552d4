// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The 3-D replay of the report, in the page: first the balls at the start, then newer and newer data.

import { readObject } from "../../../viewer/src/data.js";
import { mount } from "../../../viewer/src/replay.js";
import { onTheme } from "../theme.js";

export class ReplayPanel {
  constructor(root) {
    this.root = root;
    this.replay = null;
    onTheme(() => this.replay?.repaint());
  }

  /// `restart`: the data are of another case.
  show(film, restart) {
    if (!film || this.impossible) return;
    if (this.replay) {
      try {
        this.replay.renew(readObject(film), restart);
      } catch (error) {
        this.root.dataset.error = error.message;
      }
      return;
    }
    this.replay = mount(this.root, () => readObject(film));
    this.impossible = !this.replay;
  }
}
