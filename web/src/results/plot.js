// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Curves, drawn by uPlot in the colours of the page.

import uPlot from "uplot";
import { element } from "../dom.js";
import { onTheme } from "../theme.js";
import { short } from "../format.js";
import { text } from "../text/en.js";

const variable = (name) =>
  getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();

const font = "12px system-ui, -apple-system, 'Segoe UI', Helvetica, Arial, sans-serif";

function axis(options, size, space) {
  return { stroke: variable("soft"), font, labelFont: font, label: options.label, labelSize: 20,
    grid: { stroke: variable("grid"), width: 1 }, ticks: { stroke: variable("grid"), width: 1, size: 4 },
    size, gap: 4, space, values: (_, splits) => splits.map((at) =>
      at === null || at === undefined ? "" : (options.values ?? short)(at)) };
}

/// Marks of a logarithmic axis: powers of ten, in steps that leave at most eight and have room along the
/// x axis, number 0; 1, 2 and 5 of each if there are few.
function logarithmicMarks(plot, number, least, most) {
  const [low, high] = [Math.ceil(Math.log10(least) - 1e-9), Math.floor(Math.log10(most) + 1e-9)];
  const room = number === 0 ? plot.width / 64 : 8;
  const step = Math.max(1, Math.ceil((high - low + 1) / Math.min(room, 8)));
  const marks = [];
  for (let power = low - 1; power <= high; ++power)
    for (const digit of high - low < 2 ? [1, 2, 5] : [1]) {
      const at = Number(`${digit}e${power}`);
      if (at >= least * 0.999 && at <= most * 1.001 && (power - low) % step === 0) marks.push(at);
    }
  return marks;
}

function scaleOf({ log, range }) {
  return { distr: log ? 3 : 1, time: false, ...(range ? { range } : {}) };
}

function seriesOf({ label, colour, dash, steps, points, width = 1.8, fill }) {
  const stroke = variable(colour);
  return { label, stroke, width, dash, fill: fill ? `${stroke}22` : undefined,
    paths: steps ? uPlot.paths.stepped({ align: 1 }) : undefined,
    points: { show: points ?? false, size: 7, fill: stroke }, spanGaps: true };
}

/// Vertical bars of the half widths `halves` of the intervals around a series.
function intervals(halves, colour) {
  return (plot) => {
    const { ctx: pen } = plot;
    const [xs, ys] = plot.data;
    pen.save();
    pen.strokeStyle = variable(colour);
    pen.lineWidth = 1.5 * devicePixelRatio;
    pen.beginPath();
    xs.forEach((x, i) => {
      if (!(halves[i] > 0) || ys[i] === null) return;
      const at = plot.valToPos(x, "x", true);
      const [low, high] = [ys[i] - halves[i], ys[i] + halves[i]].map((y) => plot.valToPos(y, "y", true));
      const cap = 4 * devicePixelRatio;
      pen.moveTo(at, low);
      pen.lineTo(at, high);
      for (const end of [low, high]) {
        pen.moveTo(at - cap, end);
        pen.lineTo(at + cap, end);
      }
    });
    pen.stroke();
    pen.restore();
  };
}

export class Plot {
  constructor(title) {
    this.box = element("div", { className: "plot" });
    this.caption = element("figcaption", {}, element("strong", { textContent: title }));
    this.tools = element("span", { className: "tools" });
    this.caption.append(this.tools);
    this.box.setAttribute("role", "img");
    this.box.setAttribute("aria-label", title);
    this.title = title;
    this.root = element("figure", { className: "plot-figure" }, this.caption, this.box);
    new ResizeObserver(() => this.fit()).observe(this.box);
    onTheme(() => this.content && this.show(this.content));
  }

  height() {
    return Math.round(Math.min(Math.max(this.box.clientWidth * 0.64, 220), 400));
  }

  fit() {
    const width = this.box.clientWidth;
    if (!this.content || width === 0) return;
    if (!this.plot) this.show(this.content);
    else if (width !== this.plot.width) this.plot.setSize({ width, height: this.height() });
  }

  /// `content`: x { label, log, values, range }, y (the same), series [{ label, colour, ... }], data
  /// (columns: x, then one for each series), halves (of the first series), about (for readers).
  show(content) {
    this.content = content;
    if (content.about) this.box.setAttribute("aria-label", `${this.title}. ${content.about}`);
    const shape = JSON.stringify([content.x, content.y, content.series, content.scaleKey,
      document.documentElement.dataset.theme]);
    if (this.plot && shape === this.shape && !content.halves) return this.plot.setData(content.data);
    this.shape = shape;
    this.clearPlot();
    if (this.box.clientWidth > 0) this.plot = this.made(content);
  }

  made({ x, y, series, data, halves }) {
    const axes = [axis(x, 34, 64), axis(y, y.wide ?? 56, 28)];
    [x, y].forEach(({ log }, i) => log &&
      Object.assign(axes[i], { splits: logarithmicMarks, filter: (_, splits) => splits }));
    return new uPlot({ width: this.box.clientWidth, height: this.height(),
      padding: [8, 24, 0, 0], axes, scales: { x: scaleOf(x), y: scaleOf(y) },
      series: [{ label: text.at, value: (_, at) => (at == null ? "–" : (x.values ?? short)(at)) },
        ...series.map((each) => ({ ...seriesOf(each),
          value: (_, at) => (at == null ? "–" : (y.values ?? short)(at)) }))],
      hooks: halves ? { draw: [intervals(halves, series[0].colour)] } : {},
      cursor: { y: false, drag: { x: false, y: false }, points: { size: 6 } },
      legend: { show: true, live: true } }, data, this.box);
  }

  clearPlot() {
    this.plot?.destroy();
    this.plot = null;
    this.box.replaceChildren();
  }

  clear() {
    this.clearPlot();
    this.content = null;
    this.box.append(element("p", { className: "note", textContent: text.noCurve }));
  }
}
