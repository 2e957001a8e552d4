// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Whether two quantities differ.

/// "apart" if the 95 % intervals of two quantities do not overlap, "overlap" if they do, "unknown"
/// without intervals.
export function verdictOf(a, b) {
  if (!(a.ci95 >= 0) || !(b.ci95 >= 0) || a.ci95 === null || b.ci95 === null) return "unknown";
  return Math.abs(a.value - b.value) > a.ci95 + b.ci95 ? "apart" : "overlap";
}
