// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Preliminary results of a case: replicates that are still computed, merged.

import { columnOf } from "../csv.js";

const mean = (numbers) => numbers.reduce((a, b) => a + b, 0) / numbers.length;

/// One quantity over replicates: the mean, and an interval from those of the replicates.
function mergedQuantity(given) {
  const numbers = given.filter(({ value }) => Number.isFinite(value));
  if (numbers.length === 0) return { ...given[0], ci95: null };
  const halves = numbers.map(({ ci95_time: time, ci95 }) => ci95 ?? time)
    .filter((half) => half !== null && half !== undefined);
  const ci95 = halves.length === numbers.length
    ? Math.hypot(...halves) / numbers.length : null;
  return { ...numbers[0], value: mean(numbers.map(({ value }) => value)), ci95 };
}

/// Quantities of one result, merged from the summaries of its replicates.
export function mergedSummary(summaries) {
  const merged = {};
  for (const key of Object.keys(summaries[0]))
    merged[key] = key.startsWith("_") ? summaries[0][key]
      : mergedQuantity(summaries.map((summary) => summary[key]).filter(Boolean));
  return merged;
}

/// Mean of the spectra of replicates: the bins are the same in all, but some lack empty ones.
export function mergedSpectrum(tables) {
  if (tables.length === 1) return tables[0];
  const { names } = tables[0];
  const bins = new Map();
  for (const table of tables) {
    const lows = columnOf(table, names[0]);
    table.rows.forEach((row, i) => {
      const bin = bins.get(lows[i]);
      if (!bin) bins.set(lows[i], row.map((cell, c) => (c < 2 ? cell : cell / tables.length)));
      else for (let c = 2; c < row.length; ++c) bin[c] += row[c] / tables.length;
    });
  }
  return { names, rows: [...bins.values()].sort((a, b) => a[0] - b[0]) };
}
