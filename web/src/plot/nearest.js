// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The points of a plot under the pointer.

const reach = 28; // px

/// Number of the bin that holds `x`; -1 beyond the ends.
function binAt(edges, x) {
  for (let i = 0; i + 1 < edges.length; ++i) if (x >= edges[i] && x < edges[i + 1]) return i;
  return -1;
}

function nearestAlong(series, place, pointer) {
  let best = { distance: Infinity };
  series.x.forEach((x, i) => {
    const distance = Math.abs(place(x, series.y[i])[0] - pointer.x);
    if (distance < best.distance && Number.isFinite(series.y[i])) best = { series, i, distance };
  });
  return best;
}

function nearestDot(series, place, pointer) {
  let best = { distance: Infinity };
  series.x.forEach((x, i) => {
    const [px, py] = place(x, series.y[i]);
    const distance = Math.hypot(px - pointer.x, py - pointer.y);
    if (distance < best.distance) best = { series, i, distance };
  });
  return best;
}

/// What is told at `pointer` { x, y } [px], whose value on the x axis is `value`: of histograms the bin, of
/// curves the point nearest along x, else the nearest dot. A list of { series, i }.
export function nearest(plot, place, pointer, value) {
  const dots = plot.series.filter(({ mark }) => mark === "dots" || mark === "squares")
    .map((series) => nearestDot(series, place, pointer)).filter(({ distance }) => distance < reach);
  if (dots.length > 0) return [dots.reduce((a, b) => (b.distance < a.distance ? b : a))];
  const bins = plot.series.filter(({ mark }) => mark === "steps")
    .map((series) => ({ series, i: binAt(series.x, value) })).filter(({ i }) => i >= 0);
  const mark = plot.series.some((series) => series.mark === "points") ? "points" : "line"; // not fitted curves
  const along = plot.series.filter((series) => series.mark === mark)
    .map((series) => nearestAlong(series, place, pointer)).filter(({ distance }) => distance < Infinity);
  const least = Math.min(...along.map(({ distance }) => distance));
  return [...bins, ...along.filter(({ distance }) => distance < least + 2)];
}
