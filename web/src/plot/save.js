// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What can be saved of a plot: its numbers, its picture as it is shown, and its picture for print.

import { save } from "../dom.js";
import { dashOf, colourOf } from "./draw.js";
import { plain } from "./words.js";

/// "spectrum-of-impact-energies" of a title.
export const fileName = (title) =>
  plain(title).toLowerCase().replace(/[^a-z0-9]+/g, "-").replace(/^-|-$/g, "") || "plot";

const cell = (text) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);

/// A row for each point of each series: name, x (of a bin: its lower edge and its upper), y and the ends of its
/// interval.
export function csv(plot) {
  const bins = plot.series.some(({ mark }) => mark === "steps");
  const ends = plot.series.some(({ low }) => low);
  const [x, y] = [plain(plot.x.label), plain(plot.y.label)];
  const lines = [["series", ...(bins ? [`${x}, from`, `${x}, to`] : [x]), y, ...(ends ? ["low", "high"] : [])]];
  for (const { name, mark, x: xs, y: ys, low, high } of plot.series)
    for (let i = 0; i < (mark === "steps" ? ys.length : xs.length); ++i)
      lines.push([plain(name), ...(bins ? [xs[i], mark === "steps" ? xs[i + 1] : xs[i]] : [xs[i]]), ys[i],
        ...(ends ? [low?.[i], high?.[i]] : [])]);
  return csvOf(lines);
}

export const csvOf = (rows) => rows.map((row) => row.map((each) => cell(String(each ?? ""))).join(",")).join("\n") + "\n";

function drawLegend(pen, plot, isDark, left, top) {
  let x = left;
  for (const series of plot.series.filter(({ name }) => name)) {
    pen.strokeStyle = pen.fillStyle = colourOf(series, isDark);
    pen.setLineDash(dashOf(series));
    pen.lineWidth = 2;
    pen.beginPath();
    if (series.mark !== "note") pen.moveTo(x, top - 4), pen.lineTo(x + 18, top - 4);
    pen.stroke();
    pen.setLineDash([]);
    pen.fillStyle = isDark ? "#e4e8ec" : "#1d2329";
    pen.fillText(plain(series.name), x + 24, top);
    x += 40 + pen.measureText(plain(series.name)).width;
  }
}

/// The canvas of a plot with its title, legend and labels.
export function picture(plot, canvas, isDark, scale) {
  const [head, foot] = [52, 26];
  const made = document.createElement("canvas");
  made.width = canvas.width;
  made.height = canvas.height + (head + foot) * scale;
  const pen = made.getContext("2d");
  pen.scale(scale, scale);
  const width = made.width / scale, height = made.height / scale;
  pen.fillStyle = isDark ? "#14181c" : "#fff";
  pen.fillRect(0, 0, width, height);
  pen.drawImage(canvas, 0, head, width, canvas.height / scale);
  pen.fillStyle = isDark ? "#e4e8ec" : "#1d2329";
  pen.font = "600 14px system-ui, sans-serif";
  pen.fillText(plain(plot.title), 8, 18, width - 16);
  pen.font = "12px system-ui, sans-serif";
  pen.fillText(plain(plot.y.label), 8, 48, width / 2);
  drawLegend(pen, plot, isDark, 8, 34);
  pen.fillStyle = isDark ? "#e4e8ec" : "#1d2329";
  pen.textAlign = "center";
  pen.fillText(plain(plot.x.label), width / 2, height - 8, width - 16);
  return made;
}

/// Saves an SVG text as a PNG picture of twice its size.
export async function savePng(name, svg) {
  const image = new Image();
  image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(svg)}`;
  await image.decode();
  const canvas = Object.assign(document.createElement("canvas"), { width: 2 * image.width, height: 2 * image.height });
  canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
  canvas.toBlob((made) => save(`${name}.png`, made));
}
