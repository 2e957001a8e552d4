// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The scale of colours of maps: viridis, which rises evenly in print and for colour-blind readers.

import { viridis as colours } from "../../../viewer/src/viridis.js";

const steps = colours.map((colour) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16)));

/// The colour at `share`, from 0 (dark blue) to 1 (yellow).
export function viridis(share) {
  const at = Math.min(Math.max(share, 0), 1) * (steps.length - 1);
  const low = Math.min(Math.floor(at), steps.length - 2), part = at - low;
  return `#${steps[low].map((from, k) => Math.round(from + part * (steps[low + 1][k] - from))
    .toString(16).padStart(2, "0")).join("")}`;
}
