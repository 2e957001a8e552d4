// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Maps: grids of cells whose colours are values, with arrows, and what a cell says.

import { scaledText, short } from "../format.js";

import { colourOf } from "./draw.js";
import { linearMarks, logarithmicMarks, onAxis } from "./scales.js";
import { Svg, widthOf, wrapped } from "./svg.js";
import { viridis } from "./viridis.js";

const levels = 64; // few distinct colours for many cells
const countOf = ({ edges, names }) => names?.length ?? edges.length - 1;

/// Place of a value on the scale of colours: 0 to 1; null without a value.
function shareOf(map, value) {
  if (value === null) return null;
  const at = map.most > map.least ? onAxis(value, [map.least, map.most], map.log) : 0.5;
  return Math.round(Math.min(Math.max(at, 0), 1) * levels) / levels;
}

const inkOn = (share) => (share < 0.5 ? "#fff" : "#000");
const wordInk = (kind) => ([3, 4, 5].includes(kind % 7) ? "#000" : "#fff"); // pink, orange and light blue are light

/// [colour, ink on it] of a value of the map.
function colouring(map, value, isDark) {
  if (map.words.length > 0) return [colourOf({ colour: value }, isDark), isDark ? "#000" : wordInk(value)];
  const share = shareOf(map, value);
  return [viridis(share), inkOn(share)];
}

/// Places of a panel [px]: `x(i)` and `y(j)` of the edges of the cells.
function layout(panel, width, left, top) {
  const columns = countOf(panel.x), rows = countOf(panel.y), named = panel.y.names !== undefined;
  const before = panel.polar ? 4 : 26 + Math.max(...axisMarks(panel.y, 5).map(({ text }) => widthOf(text)), 12);
  const wide = Math.min(width, panel.width) - before - 12;
  const tall = named ? rows * Math.min(Math.max(240 / rows, 0.5), 44) : panel.polar ? wide : panel.shape * wide;
  const box = { left: left + before, top: top + 24, wide, tall };
  const place = (axis, count) => (i) => (axis.names ? i / count : onAxis(axis.edges[i], [axis.edges[0], axis.edges.at(-1)], axis.log));
  const [px, py] = [place(panel.x, columns), place(panel.y, rows)];
  return { panel, columns, rows, ...box, x: (i) => box.left + wide * px(i), y: (j) => box.top + tall * (1 - py(j)),
    width: Math.min(width, panel.width), height: 24 + tall + (panel.polar ? 10 : 44) };
}

/// Marks of an axis: where they stand between its ends (0 to 1), and their texts.
function axisMarks(axis, wanted) {
  if (axis.names) return axis.names.map((text, i) => ({ at: (i + 0.5) / axis.names.length, text }));
  const ends = [axis.edges[0], axis.edges.at(-1)];
  return (axis.log ? logarithmicMarks : linearMarks)(...ends, wanted).map((value) => ({
    at: onAxis(value, ends, axis.log), text: axis.unit ? scaledText(value, axis.unit) : short(value) }));
}

/// Marks as many as have room.
function thinned(marks, room, size) {
  const step = Math.max(1, Math.ceil(marks.length * size / room));
  return marks.filter((_, i) => i % step === 0);
}

function drawAxes(svg, { panel, left, top, wide, tall }) {
  const xs = axisMarks(panel.x, Math.max(2, wide / 70)), ys = axisMarks(panel.y, Math.max(2, tall / 40));
  const widest = Math.max(...xs.map(({ text }) => widthOf(text)), 0) + 10;
  for (const { at, text } of thinned(xs, wide, widest)) svg.text(left + wide * at, top + tall + 16, text, { anchor: "middle" });
  for (const { at, text } of thinned(ys, tall, 15)) svg.text(left - 6, top + tall * (1 - at) + 4, text, { anchor: "end" });
  svg.rect(left, top, wide, tall, `fill="none" stroke="${svg.colours.grid}"`);
  svg.text(left + wide / 2, top + tall + 34, panel.x.label, { anchor: "middle", fill: svg.colours.ink });
  svg.upright(left - 14 - Math.max(...ys.map(({ text }) => widthOf(text)), 0), top + tall / 2, panel.y.label);
}

const box = (x, y, w, h) => `M${x.toFixed(1)} ${y.toFixed(1)}h${w.toFixed(2)}v${h.toFixed(2)}h${(-w).toFixed(2)}z`;

/// A piece of a ring from radius a to b [px] and between two angles [°].
function sector({ left, top, wide }, a, b, from, to) {
  const at = (r, angle) => `${(left + wide / 2 + r * Math.cos(angle * Math.PI / 180)).toFixed(1)} ` +
    (top + wide / 2 - r * Math.sin(angle * Math.PI / 180)).toFixed(1);
  return `M${at(b, from)}A${b.toFixed(1)} ${b.toFixed(1)} 0 0 0 ${at(b, to)}L${at(a, to)}A${a.toFixed(1)} ${a.toFixed(1)} 0 0 1 ${at(a, from)}z`;
}

function outline(placed, i, j) {
  const { panel, x, y, wide } = placed, { edges } = panel.y;
  const radius = (k) => wide / 2 * edges[k] / edges.at(-1);
  return panel.polar ? sector(placed, radius(j), radius(j + 1), panel.x.edges[i], panel.x.edges[i + 1])
    : box(x(i), y(j + 1), x(i + 1) - x(i), y(j) - y(j + 1));
}

/// Cells of one colour are one path.
function drawCells(svg, map, placed) {
  const { panel, columns } = placed, paths = new Map();
  panel.values.forEach((value, k) => {
    const failed = panel.failed?.[k];
    if (value === null && !failed) return;
    const colour = failed ? svg.colours.grid : colouring(map, value, svg.colours.isDark)[0];
    paths.set(colour, (paths.get(colour) ?? "") + outline(placed, k % columns, Math.floor(k / columns)));
  });
  const line = panel.x.names && columns < 60 ? `stroke="${svg.colours.ground ?? "var(--paper)"}"` : "";
  for (const [colour, d] of paths) svg.path(d, `fill="${colour}" ${line || `stroke="${colour}" stroke-width="0.4"`}`);
}

const cellText = (map, value) => (map.words.length > 0 ? map.words[value]
  : Math.abs(value) >= 999.5 && Math.abs(value) < 1e6 ? value.toFixed(0) : short(value));

/// Numbers in the cells, if there is room in all of them, and crosses in those that failed.
function drawTexts(svg, map, { panel, columns, x, y }) {
  if (!panel.x.names) return;
  const texts = panel.values.map((value) => (value === null ? "" : cellText(map, value)));
  const [wide, tall] = [x(1) - x(0), y(0) - y(1)];
  const fits = Math.max(...texts.map(widthOf)) < wide - 2 && tall >= 15;
  texts.forEach((text, k) => {
    const [cx, cy] = [x(k % columns) + wide / 2, y(Math.floor(k / columns)) - tall / 2];
    if (panel.failed?.[k]) svg.path(`M${cx - 0.2 * wide} ${cy - 0.2 * tall}l${0.4 * wide} ${0.4 * tall}m0 ${-0.4 * tall}l${-0.4 * wide} ${0.4 * tall}`,
      `fill="none" stroke="${svg.colours.soft}"`);
    else if (fits && text) svg.text(cx, cy + 4, text, { anchor: "middle", more: ' font-size="11"',
      fill: colouring(map, panel.values[k], svg.colours.isDark)[1] });
  });
}

/// Black arrows with a light edge: [column, row, along x, along y] of each.
function drawArrows(svg, { panel, x, y }) {
  const size = 3.9 * (x(1) - x(0));
  let d = "";
  for (let k = 0; k + 3 < (panel.arrows?.length ?? 0); k += 4) {
    const [i, j, u, v] = panel.arrows.slice(k, k + 4), [dx, dy] = [size * u, -size * v];
    const part = (px, py) => `l${px.toFixed(1)} ${py.toFixed(1)}`;
    d += `M${((x(i) + x(i + 1)) / 2).toFixed(1)} ${((y(j) + y(j + 1)) / 2).toFixed(1)}${part(dx, dy)}` +
      `m${(-0.35 * dx - 0.2 * dy).toFixed(1)} ${(-0.35 * dy + 0.2 * dx).toFixed(1)}` +
      part(0.35 * dx + 0.2 * dy, 0.35 * dy - 0.2 * dx) + part(-0.35 * dx + 0.2 * dy, -0.35 * dy - 0.2 * dx);
  }
  if (!d) return;
  svg.path(d, 'fill="none" stroke="#fff" stroke-width="2.2" stroke-opacity="0.55"');
  svg.path(d, 'fill="none" stroke="#000" stroke-width="0.9"');
}

function drawLines(svg, { panel, left, top, wide, tall }) {
  if (panel.ring > 0) {
    const radius = panel.ring / (panel.x.edges.at(-1) - panel.x.edges[0]) * wide;
    svg.parts.push(`<circle cx="${left + wide / 2}" cy="${top + tall / 2}" r="${radius.toFixed(1)}" fill="none" stroke="${svg.colours.soft}" stroke-width="1.5"/>`);
  }
  if (panel.diagonal) svg.path(`M${left} ${top + tall}L${left + wide} ${top}`, `stroke="${svg.colours.soft}" stroke-dasharray="4 4"`);
}

/// The scale of colours, or the words. Returns its lower end.
function drawScale(svg, map, left, top, width) {
  const value = (number) => (map.unit ? scaledText(number, map.unit) : short(number));
  if (map.words.length > 0) {
    let [x, y] = [left, top + 4];
    map.words.forEach((word, kind) => {
      const room = 34 + widthOf(word);
      if (x > left && x + room > left + width) [x, y] = [left, y + 20];
      svg.rect(x, y, 12, 12, `fill="${colourOf({ colour: kind }, svg.colours.isDark)}"`);
      svg.text(x + 18, y + 10.5, word, { fill: svg.colours.ink });
      x += room;
    });
    return y + 22;
  }
  const wide = Math.min(width - 8, 330), steps = 48;
  for (let i = 0; i < steps; ++i)
    svg.path(box(left + wide * i / steps, top, wide / steps + 0.5, 10), `fill="${viridis((i + 0.5) / steps)}"`);
  svg.text(left, top + 25, value(map.least));
  svg.text(left + wide, top + 25, value(map.most), { anchor: "end" });
  svg.text(left + wide / 2, top + 25, map.log ? "logarithmic" : "", { anchor: "middle" });
  svg.text(left, top + 42, map.quantity, { fill: svg.colours.ink });
  const beside = wide + 20 + widthOf(map.note) < width;
  const notes = wrapped(map.note, beside ? Infinity : width);
  notes.forEach((line, i) => svg.text(beside ? left + wide + 20 : left, beside ? top + 9 : top + 58 + 16 * i, line));
  return top + 50 + (beside ? 0 : 16 * notes.length);
}

/// What a cell says: its value, and where it is.
function told(map, panel, columns, k) {
  const said = panel.told?.[k], value = panel.values[k];
  if (said) {
    const colon = said.lastIndexOf(": ");
    return { at: said.slice(0, colon), value: said.slice(colon + 2) };
  }
  if (value === null) return null;
  const range = ({ label, edges, unit }, i) => {
    const [low, high] = [edges[i], edges[i + 1]].map((edge) => (unit ? scaledText(edge, unit) : short(edge)));
    return `${label.replace(/ \(.*|, .*/, "")} ${low} to ${high}${label.match(/\(([^)]*)\)/)?.[1].replace(/^/, " ") ?? ""}`;
  };
  return { at: `${range(panel.x, k % columns)}, ${range(panel.y, Math.floor(k / columns))}`,
    value: map.unit ? scaledText(value, map.unit) : short(value) };
}

const cellAt = (axis, position, count) => {
  if (!(position >= 0 && position < 1)) return -1;
  if (axis.names) return Math.floor(position * count);
  const ends = [axis.edges[0], axis.edges.at(-1)];
  for (let i = 0; i < count; ++i) if (position < onAxis(axis.edges[i + 1], ends, axis.log)) return i;
  return -1;
};

/// Number of the cell of a panel at a place of the picture [px]; -1 outside.
function cellUnder({ panel, columns, rows, left, top, wide, tall }, px, py) {
  let [across, up] = [(px - left) / wide, 1 - (py - top) / tall];
  if (panel.polar) {
    const [dx, dy] = [2 * across - 1, 2 * up - 1];
    across = (Math.atan2(dy, dx) / (2 * Math.PI) + 1) % 1;
    up = Math.hypot(dx, dy);
  }
  const [i, j] = [cellAt(panel.x, across, columns), cellAt(panel.y, up, rows)];
  return i < 0 || j < 0 ? -1 : j * columns + i;
}

/// Panels side by side, in as many rows as they need.
function arranged(map, width) {
  let [left, top, tallest] = [0, 0, 0];
  return map.panels.map((panel) => {
    if (left > 0 && left + panel.width > width + 1) [left, top, tallest] = [0, top + tallest, 0];
    const placed = layout(panel, width, left, top);
    left += placed.width;
    tallest = Math.max(tallest, placed.height);
    return placed;
  });
}

/// The picture of a map `width` px wide: its SVG, and `tell(x, y)`, what stands at a place of it.
export function drawMap(map, width, colours) {
  const svg = new Svg(colours), panels = arranged(map, width);
  for (const placed of panels) {
    const { panel } = placed;
    svg.text(placed.left, placed.top - 8, panel.title);
    drawCells(svg, map, placed);
    drawTexts(svg, map, placed);
    drawArrows(svg, placed);
    drawLines(svg, placed);
    if (!panel.polar) drawAxes(svg, placed);
  }
  const bottom = Math.max(...panels.map(({ top, height }) => top - 24 + height));
  const height = drawScale(svg, map, panels[0].left, bottom + 8, width - panels[0].left);
  const tell = (x, y) => {
    for (const placed of panels) {
      const k = cellUnder(placed, x, y);
      if (k >= 0) return told(map, placed.panel, placed.columns, k);
    }
    return null;
  };
  return { svg: svg.drawn(width, height, map.title), tell };
}

/// A row for each cell with a value.
export function mapRows(map) {
  const ends = ({ label, names }) => (names ? [label] : [`${label}, from`, `${label}, to`]);
  const cell = ({ names, edges }, i) => (names ? [names[i]] : [edges[i], edges[i + 1]]);
  const unit = map.unit ? ` (${map.unit})` : "";
  return [["part", ...ends(map.panels[0].x), ...ends(map.panels[0].y), `${map.quantity}${unit}`],
    ...map.panels.flatMap((panel) => panel.values.map((value, k) => {
      const columns = countOf(panel.x);
      return value === null ? null : [panel.title, ...cell(panel.x, k % columns), ...cell(panel.y, Math.floor(k / columns)),
        map.words.length > 0 ? map.words[value] : value];
    }).filter(Boolean))];
}
