// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What colours and marks can show of the present data, and what they show at a state of the replay.

import { legendOf, lifeOf, markedAt } from "./hits.js";
import { coloursOf, scaleOf } from "./quantities.js";

export class Shown {
  constructor(data, text) {
    this.data = data;
    this.colours = coloursOf(data, text);
    this.scales = {}; // of quantities, as they are needed
    this.legend = data.hits?.count > 0 ? legendOf(data) : null;
  }

  has(colour) {
    return this.colours.some(({ key }) => key === colour);
  }

  /// The scale of a colour's quantity; null for kinds.
  scale(colour) {
    return colour === "species" ? null : (this.scales[colour] ??= scaleOf(this.data, colour));
  }

  /// The legend of the marks of hits; null if none are shown.
  hitLegend({ hits }) {
    return hits ? this.legend : null;
  }

  /// What the stage draws at a state of the replay.
  drawn(state) {
    const { frame, view, picked, colour } = state;
    return { frame, view, picked, scale: this.scale(colour),
      life: this.hitLegend(state) && lifeOf(this.data, state) };
  }

  /// How many hits are marked; "none" without data, "off" if they are hidden.
  marks(state) {
    if (!this.legend) return "none";
    return state.hits ? markedAt(this.data, state.frame, lifeOf(this.data, state)) : "off";
  }
}
