// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The series of a plot on a canvas. `place(x, y)` is the place of a value [px of the canvas].

const light = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#666666"];
const dark = ["#4aa8e0", "#f0833a", "#2fc79a", "#dd98bd", "#f0b323", "#8ccdf2", "#a3adb8"];
const dashes = [[], [7, 3], [2, 3]]; // of the first seven colours, the next seven, ...

export const colourOf = ({ mark, colour }, isDark) =>
  mark === "squares" ? (isDark ? "#e4e8ec" : "#1d2329") : (isDark ? dark : light)[colour % light.length];
export const dashOf = ({ colour }) => dashes[Math.floor(colour / light.length) % dashes.length];

const many = 300; // dots; more are drawn small, without intervals
const joined = new Set(["line", "points"]);
const dotted = new Set(["points", "dots", "squares"]);

/// Runs of points that follow each other, all of which have a place.
function runsOf(count, placeOf) {
  const runs = [[]];
  for (let i = 0; i < count; ++i) {
    const at = placeOf(i);
    if (at) runs.at(-1).push(at);
    else if (runs.at(-1).length > 0) runs.push([]);
  }
  return runs.filter((run) => run.length > 0);
}

function path(pen, points) {
  pen.beginPath();
  points.forEach(([x, y], i) => (i === 0 ? pen.moveTo(x, y) : pen.lineTo(x, y)));
}

function drawBand(pen, series, place) {
  for (const run of runsOf(series.x.length, (i) => {
    const [low, high] = [place(series.x[i], series.low[i]), place(series.x[i], series.high[i])];
    return low && high && { low, high };
  })) {
    path(pen, [...run.map(({ low }) => low), ...run.map(({ high }) => high).reverse()]);
    pen.closePath();
    pen.globalAlpha = series.mark === "area" ? 0.25 : 0.15;
    pen.fill();
    pen.globalAlpha = 1;
  }
}

function drawLine(pen, series, place, scale) {
  pen.lineWidth = (series.mark === "points" ? 1 : 1.8) * scale;
  pen.setLineDash(dashOf(series).map((each) => each * scale));
  for (const run of runsOf(series.x.length, (i) => place(series.x[i], series.y[i]))) {
    path(pen, run);
    pen.stroke();
  }
  pen.setLineDash([]);
}

/// A histogram: x holds the edges, one more than y. `ground`: y of the bottom [px].
function drawSteps(pen, series, place, scale, ground, left) {
  const corners = [];
  series.y.forEach((y, i) => {
    const top = place(series.x[i + 1], y)?.[1] ?? ground;
    const edges = [series.x[i], series.x[i + 1]].map((x) => place(x, series.y.find((v) => v > 0))?.[0] ?? left);
    corners.push([edges[0], top], [edges[1], top]);
  });
  if (corners.length === 0) return;
  path(pen, [[corners[0][0], ground], ...corners, [corners.at(-1)[0], ground]]);
  pen.globalAlpha = 0.13;
  pen.fill();
  pen.globalAlpha = 1;
  pen.lineWidth = 1.6 * scale;
  pen.stroke();
}

function drawInterval(pen, low, high, scale) {
  pen.lineWidth = 1.2 * scale;
  pen.beginPath();
  pen.moveTo(low[0], low[1]);
  pen.lineTo(high[0], high[1]);
  for (const [x, y] of [low, high]) {
    pen.moveTo(x - 3 * scale, y);
    pen.lineTo(x + 3 * scale, y);
  }
  pen.stroke();
}

function drawDots(pen, series, place, scale, small) {
  const crowded = series.x.length > many;
  const radius = (crowded ? 1.4 : small ? 2.6 : 3.5) * scale;
  series.x.forEach((x, i) => {
    const at = place(x, series.y[i]);
    const ends = series.low && !crowded && [place(x, series.low[i]), place(x, series.high[i])];
    if (ends && ends[0] && ends[1]) drawInterval(pen, ends[0], ends[1], scale);
    if (!at) return;
    pen.beginPath();
    if (series.mark === "squares") pen.rect(at[0] - radius, at[1] - radius, 2 * radius, 2 * radius);
    else pen.arc(at[0], at[1], radius, 0, 2 * Math.PI);
    pen.fill();
  });
}

/// `box`: left, top, width, height of the plot [px]. `scale`: pixels of the canvas in one of the page.
export function drawSeries(pen, series, { place, box, scale, isDark }) {
  pen.save();
  pen.strokeStyle = pen.fillStyle = colourOf(series, isDark);
  pen.lineJoin = "round";
  const at = (x, y) => { // null where there is no number, or none on a logarithmic axis
    const found = Number.isFinite(x) && Number.isFinite(y) ? place(x, y) : [];
    return found.length > 0 && found.every(Number.isFinite) ? found : null;
  };
  if (series.low && (series.band || series.mark === "area")) drawBand(pen, series, at);
  if (series.mark === "steps") drawSteps(pen, series, at, scale, box.top + box.height + 5 * scale, box.left - 5 * scale);
  if (joined.has(series.mark)) drawLine(pen, series, at, scale);
  if (dotted.has(series.mark)) drawDots(pen, series, at, scale, box.width / scale < 330);
  pen.restore();
}
