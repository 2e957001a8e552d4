// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Groups of bars from a common base, with intervals and notes at their ends.

import { short } from "../format.js";
import { colourOf } from "./draw.js";
import { linearMarks, onAxis } from "./scales.js";
import { Svg, widthOf } from "./svg.js";

const row = 26, step = 11;

const heightOf = (plot, group) => (plot.side_by_side ? Math.max(row, 10 + step * group.bars.length) : row);

/// The range of the axis, with room for the notes at both ends.
function rangeOf({ groups, base }, room) {
  const bars = groups.flatMap((group) => group.bars).filter(({ end }) => end !== null);
  const ends = [base, ...bars.flatMap(({ end, low, high }) => [end, low ?? end, high ?? end])];
  let [least, most] = [Math.min(...ends), Math.max(...ends)];
  if (!(most > least)) most = least + Math.max(1, Math.abs(least));
  const air = (most - least) * Math.min(room / (1 - 2 * Math.min(room, 0.35)) + 0.02, 1);
  return [least < base ? least - air : least, most > base ? most + air : most];
}

function drawBar(svg, plot, bar, y, size, across) {
  if (bar.end === null) return "";
  const [from, to, middle] = [across(plot.base), across(bar.end), y + size / 2];
  svg.rect(Math.min(from, to), y, Math.abs(to - from), size, `fill="${colourOf(bar, svg.colours.isDark)}" fill-opacity="0.85"`);
  const [low, high] = [across(bar.low ?? bar.end), across(bar.high ?? bar.end)];
  if (high > low)
    svg.path(`M${low} ${middle}H${high}M${low} ${middle - 3}v6M${high} ${middle - 3}v6`, `fill="none" stroke="${svg.colours.ink}"`);
  const left = bar.end < plot.base;
  return bar.note && (() => svg.text(left ? Math.min(low, to) - 5 : Math.max(high, to) + 5, middle + 4, bar.note,
    { anchor: left ? "end" : "start", more: ` font-size="11" stroke="${svg.colours.ground ?? "var(--paper)"}" stroke-width="3" paint-order="stroke"` }));
}

function drawAxis(svg, plot, [least, most], across, top, bottom, middle) {
  for (const mark of linearMarks(least, most, 5)) {
    svg.path(`M${across(mark)} ${top}V${bottom}`, `stroke="${svg.colours.grid}"`);
    svg.text(across(mark), bottom + 17, short(mark), { anchor: "middle" });
  }
  svg.text(middle, bottom + 37, plot.label, { anchor: "middle", fill: svg.colours.ink });
}

/// Returns its lower end.
function drawLegend(svg, plot, left, right) {
  const narrow = plot.legend.reduce((sum, word) => sum + 36 + widthOf(word), left) > right;
  const first = narrow ? 4 : left;
  let [x, y] = [first, 2];
  plot.legend.forEach((word, colour) => {
    if (x > first && x + 18 + widthOf(word) > right) [x, y] = [first, y + 18];
    svg.rect(x, y, 12, 12, `fill="${colourOf({ colour }, svg.colours.isDark)}"`);
    svg.text(x + 18, y + 10.5, word, { fill: svg.colours.ink });
    x += 36 + widthOf(word);
  });
  return plot.legend.length > 0 ? y + 22 : 4;
}

/// The bars of a group at `y`; their notes come above the intervals of the others.
function drawGroup(svg, plot, group, y, across) {
  const height = heightOf(plot, group), { bars } = group;
  const first = y + (height - step * bars.length) / 2 + 1;
  bars.map((bar, i) => (plot.side_by_side ? drawBar(svg, plot, bar, first + step * i, 9, across)
    : drawBar(svg, plot, bar, y + (height - 16) / 2, 16, across))).forEach((note) => note && note());
}

/// The picture of bars `width` px wide: its SVG, and `tell(x, y)`, what stands at a place of it.
export function drawBars(plot, width, colours) {
  const svg = new Svg(colours);
  const longest = (texts) => Math.max(...texts.map(widthOf), 0);
  const left = Math.min(Math.max(16 + longest(plot.groups.map(({ name }) => name)), 60), 0.45 * width), right = width - 16;
  const notes = longest(plot.groups.flatMap(({ bars }) => bars.map(({ note }) => note)));
  const range = rangeOf(plot, (notes + 12) / (right - left));
  const across = (value) => left + onAxis(value, range) * (right - left);
  const top = drawLegend(svg, plot, left, right), rows = [];
  let bottom = top;
  for (const group of plot.groups) bottom += heightOf(plot, group);
  drawAxis(svg, plot, range, across, top, bottom, (left + right) / 2);
  let y = top;
  for (const group of plot.groups) {
    const height = heightOf(plot, group);
    svg.text(left - 8, y + height / 2 + 4, group.name, { anchor: "end", fill: svg.colours.ink });
    drawGroup(svg, plot, group, y, across);
    rows.push({ group, from: y, to: y += height });
  }
  svg.path(`M${across(plot.base)} ${top}V${bottom}`, `stroke="${svg.colours.ink}"`);
  const tell = (_, at) => {
    const found = rows.find(({ from, to }) => at >= from && at < to);
    return found && { at: found.group.name, value: found.group.bars.filter(({ end }) => end !== null)
      .map((bar) => textOf(bar, plot.legend[bar.colour])).join("; ") };
  };
  return { svg: svg.drawn(width, bottom + 46, plot.title), tell };
}

const textOf = ({ end, low, high, note }, name = "") => [name && `${name}: `, short(end),
  low !== null && high > low ? ` (${short(low)} to ${short(high)})` : "", note && ` at ${note}`].join("");

/// A row for each bar.
export const barRows = (plot) => [["name", "bar", plot.label, "low", "high", "note"],
  ...plot.groups.flatMap(({ name, bars }) => bars.map(({ end, low, high, colour, note }) =>
    [name, plot.legend[colour] ?? "", end, low, high, note]))];
