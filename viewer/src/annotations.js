// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Annotations of the picture: time, legend and direction of gravity. They are drawn on a 2-D
// canvas; the screen, saved pictures, videos and prints show the same annotations.

import { gradient, speciesColours } from "./colours.js";
import { hitColour, legendOf } from "./hits.js";
import { multipleOf } from "./quantities.js";
import { short } from "./words.js";

const font = "system-ui, -apple-system, 'Segoe UI', Helvetica, Arial, sans-serif";
const margin = 14;
const pickedText = ({ dark }) => (dark ? "#ff8a5c" : "#d0410c");

function write(pen, text, x, y, { size = 12, weight = 400, align = "left", colour }) {
  pen.font = `${weight} ${size}px ${font}`;
  pen.textAlign = align;
  pen.fillStyle = colour;
  pen.fillText(text, x, y);
}

function drawTime(pen, width, { time, factor, theme }) {
  write(pen, time, width - margin, margin + 14,
    { size: 16, weight: 600, align: "right", colour: theme.ink });
  write(pen, factor, width - margin, margin + 31, { align: "right", colour: theme.soft });
}

function drawQuantityLegend(pen, height, { theme, scale, colour, words }) {
  const [long, thick, y] = [150, 9, height - margin - 26];
  const fill = pen.createLinearGradient(margin, 0, margin + long, 0);
  gradient.forEach((each, i) => fill.addColorStop(i / (gradient.length - 1), each));
  write(pen, words.colours[colour].scale(scale.unit), margin, y - 8, { colour: theme.soft });
  pen.fillStyle = fill;
  pen.beginPath();
  pen.roundRect(margin, y, long, thick, thick / 2);
  pen.fill();
  const most = scale.top / scale.factor;
  const top = scale.exceeded ? `\u2265\u2009${short(most)}` : short(most);
  [["0", "left", 0], [short(most / 2), "center", long / 2], [top, "right", long]]
    .forEach(([text, align, x]) =>
      write(pen, text, margin + x, y + thick + 14, { align, colour: theme.soft }));
}

function drawSpeciesLegend(pen, height, { theme, speciesNames }) {
  speciesNames.forEach((name, i) => {
    const y = height - margin - 6 - 18 * (speciesNames.length - 1 - i);
    pen.fillStyle = speciesColours[i % speciesColours.length];
    pen.beginPath();
    pen.arc(margin + 5, y, 5, 0, 2 * Math.PI);
    pen.fill();
    write(pen, name, margin + 17, y + 4, { colour: theme.soft });
  });
}

/// Rings of three energies, of two in a narrow picture, at the upper left.
function drawHitsLegend(pen, width, { theme, hits, title, words }) {
  const y = margin + (title ? 34 : 14);
  write(pen, words.hitsScale, margin, y, { colour: theme.soft });
  let x = margin;
  for (const { energy, strength, size } of width < 480 ? [hits[0], hits[2]] : hits) {
    const { factor, unit } = multipleOf(energy, "J");
    pen.strokeStyle = hitColour(strength);
    pen.lineWidth = 1 + 2.2 * strength;
    pen.beginPath();
    pen.arc(x + size / 2, y + 26, (size - pen.lineWidth) / 2, 0, 2 * Math.PI);
    pen.stroke();
    const text = `${short(energy / factor)} ${unit}`;
    write(pen, text, x + size + 4, y + 30, { colour: theme.soft });
    x += size + 4 + pen.measureText(text).width + 10;
  }
}

/// Direction of gravity: an arrow in the plane of the picture; a dot if gravity points out of the
/// picture, a cross if it points into it.
function drawWeight(pen, width, height, { theme, weight, words }) {
  const [x, y, long] = [width - margin - 22, height - margin - 22, 20];
  const [dx, dy] = [weight.x, -weight.y];
  const size = Math.hypot(dx, dy);
  pen.strokeStyle = pen.fillStyle = theme.soft;
  pen.lineWidth = 1.5;
  pen.beginPath();
  if (size < 0.25) {
    pen.arc(x, y, 6, 0, 2 * Math.PI);
    if (weight.z < 0)
      for (const k of [-1, 1]) {
        pen.moveTo(x - 4, y - 4 * k);
        pen.lineTo(x + 4, y + 4 * k);
      }
    pen.stroke();
    if (weight.z > 0) pen.fillRect(x - 1.5, y - 1.5, 3, 3);
    write(pen, words.weight, x - 16, y + 4, { colour: theme.soft });
    return;
  }
  const [tipX, tipY] = [x + dx * long, y + dy * long];
  const [ux, uy] = [dx / size, dy / size];
  pen.moveTo(x - dx * long, y - dy * long);
  pen.lineTo(tipX - 5 * ux, tipY - 5 * uy);
  pen.stroke();
  pen.beginPath();
  pen.moveTo(tipX, tipY);
  pen.lineTo(tipX - 8 * ux - 4 * uy, tipY - 8 * uy + 4 * ux);
  pen.lineTo(tipX - 8 * ux + 4 * uy, tipY - 8 * uy - 4 * ux);
  pen.fill();
  write(pen, words.weight, x - 12 * Math.abs(uy) - 4, y + 4 - 12 * Math.abs(ux), { colour: theme.soft });
}

/// A bar of 1, 2 or 5 times a power of ten, at most 110 pixels long; it holds at the middle of the picture.
function drawScale(pen, width, height, { theme, pixelsOfMetre }) {
  const most = 110 / pixelsOfMetre;
  const decade = 10 ** Math.floor(Math.log10(most));
  const metres = [5, 2, 1].find((step) => step * decade <= most) * decade;
  const long = metres * pixelsOfMetre;
  const [left, y] = [width - margin - 60 - long, height - margin - 6];
  pen.strokeStyle = theme.soft;
  pen.lineWidth = 1.5;
  pen.beginPath();
  for (const [fromX, fromY, toX, toY] of [[0, 0, long, 0], [0, -4, 0, 4], [long, -4, long, 4]]) {
    pen.moveTo(left + fromX, y + fromY);
    pen.lineTo(left + toX, y + toY);
  }
  pen.stroke();
  const text = metres < 1 ? `${short(1e3 * metres)} mm` : `${short(metres)} m`;
  write(pen, text, left + long / 2, y - 8, { align: "center", colour: theme.soft });
}

/// Draws on `pen`; the unit is a CSS pixel, the picture has `width` times `height` pixels. `what`:
/// theme, title (or none), time and factor as text, colour, scale of its quantity, speciesNames, weight, pixelsOfMetre,
/// `hits`: the legend of their marks or none, `picked`: lines on the picked ball, and `words`, those of the replay.
export function annotate(pen, width, height, what) {
  if (what.title)
    write(pen, what.title, margin, margin + 14, { size: 14, weight: 600, colour: what.theme.ink });
  drawTime(pen, width, what);
  drawScale(pen, width, height, what);
  what.picked.forEach((line, i) => write(pen, line, width - margin, margin + 52 + 16 * i,
    { weight: i === 0 ? 600 : 400, align: "right", colour: pickedText(what.theme) }));
  if (what.hits) drawHitsLegend(pen, width, what);
  if (what.colour === "species") drawSpeciesLegend(pen, height, what);
  else drawQuantityLegend(pen, height, what);
  drawWeight(pen, width, height, what);
}
