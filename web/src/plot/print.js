// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A plot for print, as SVG: the range and the axes that the reader has chosen, on white.

import { colourOf, dashOf, drawSeries } from "./draw.js";
import { linearMarks, logarithmicMarks, markText, onAxis } from "./scales.js";
import { inPrint, Svg, SvgPen, widthOf } from "./svg.js";

const wide = 640, right = wide - 16;

function legend(svg, plot, left, top) {
  let [x, y] = [left, top];
  for (const series of plot.series.filter(({ name }) => name)) {
    const room = 42 + widthOf(series.name);
    if (x > left && x + room > right) [x, y] = [left, y + 18];
    const dash = dashOf(series);
    if (series.mark !== "note")
      svg.path(`M${x} ${y - 4}h18`, `stroke="${colourOf(series, false)}" stroke-width="${series.mark === "area" ? 8 : 2.5}"` +
        (series.mark === "area" ? ' stroke-opacity="0.3"' : "") + (dash.length ? ` stroke-dasharray="${dash.join(" ")}"` : ""));
    svg.text(x + 24, y, series.name, { fill: inPrint.ink });
    x += room;
  }
  return y;
}

function axes(svg, plot, box, ticks, at) {
  const { left, top, width, height } = box, bottom = top + height;
  for (const mark of ticks.x) {
    svg.path(`M${at.x(mark)} ${top}V${bottom}`, `stroke="${inPrint.grid}"`);
    svg.text(at.x(mark), bottom + 17, markText(mark, plot.x.log), { anchor: "middle" });
  }
  for (const mark of ticks.y) {
    svg.path(`M${left} ${at.y(mark)}H${left + width}`, `stroke="${inPrint.grid}"`);
    svg.text(left - 7, at.y(mark) + 4, markText(mark, plot.y.log), { anchor: "end" });
  }
  svg.path(`M${left} ${top}V${bottom}H${left + width}`, `fill="none" stroke="${inPrint.soft}"`);
  svg.text(left + width / 2, bottom + 37, plot.x.label, { anchor: "middle", fill: inPrint.ink });
  svg.upright(14, top + height / 2, plot.y.label);
}

/// `view`: the limits of both axes.
export function printed(plot, view) {
  const svg = new Svg(inPrint);
  svg.text(16, 18, plot.title, { fill: inPrint.ink, more: ' font-size="14" font-weight="600"' });
  const ticks = Object.fromEntries(["x", "y"].map((key) => [key,
    (plot[key].log ? logarithmicMarks : linearMarks)(...view[key], key === "x" ? 8 : 7)]));
  const left = 36 + Math.max(...ticks.y.map((mark) => widthOf(markText(mark, plot.y.log))), 20);
  const named = plot.series.some(({ name }) => name);
  const top = named ? legend(svg, plot, left, 40) + 12 : 30;
  const box = { left, top, width: right - left, height: Math.round(wide * Math.min(Math.max(plot.shape, 0.4), 0.8)) - 80 };
  const at = { x: (value) => left + box.width * onAxis(value, view.x, plot.x.log),
    y: (value) => top + box.height * (1 - onAxis(value, view.y, plot.y.log)) };
  axes(svg, plot, box, ticks, at);
  const pen = new SvgPen(svg);
  svg.parts.push(`<svg x="${left - 4}" y="${top - 4}" width="${box.width + 8}" height="${box.height + 8}" ` +
    `viewBox="${left - 4} ${top - 4} ${box.width + 8} ${box.height + 8}">`);
  for (const series of plot.series)
    drawSeries(pen, series, { place: (x, y) => [at.x(x), at.y(y)], box, scale: 1, isDark: false });
  svg.parts.push("</svg>");
  return svg.drawn(wide, top + box.height + 46, plot.title);
}
