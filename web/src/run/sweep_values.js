// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The values of a sweep.

/// `count` numbers from `from` to `to`, equally spaced or with equal ratios.
export function valuesBetween(from, to, count, logarithmic) {
  return Array.from({ length: count }, (_, i) => {
    const part = count > 1 ? i / (count - 1) : 0;
    const value = logarithmic ? from * (to / from) ** part : from + part * (to - from);
    return Number(value.toPrecision(4));
  });
}
