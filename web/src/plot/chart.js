// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A plot: axes and zoom by uPlot, series by draw.js, values under the pointer, and what can be saved.

import uPlot from "uplot";
import { button, download, element, save } from "../dom.js";
import { short } from "../format.js";
import { colourOf, dashOf, drawSeries } from "./draw.js";
import { nearest } from "./nearest.js";
import { printed } from "./print.js";
import { csv, fileName, picture } from "./save.js";
import { limits, logarithmicMarks, markText, mayBeLog } from "./scales.js";
import { at, plain, rich, valueText } from "./words.js";

const font = "12px system-ui, -apple-system, 'Segoe UI', Helvetica, Arial, sans-serif";

function axis(colours, log, size, space) {
  const made = { stroke: colours.soft, font, grid: { stroke: colours.grid, width: 1 },
    ticks: { stroke: colours.grid, width: 1, size: 4 }, size, gap: 4, space,
    values: (_, splits) => splits.map((each) => (each === null ? "" : markText(each, log))) };
  return !log ? made : { ...made, filter: (_, splits) => splits, splits: (plot, number, least, most) =>
    logarithmicMarks(least, most, number === 0 ? plot.width / 64 : plot.height / 30) };
}

const legendEntry = (series, isDark) => element("li", {},
  series.mark === "note" ? [] : element("span", { className: `swatch ${dashOf(series).length ? "dashed" : ""}`,
    style: `color:${colourOf(series, isDark)}` }), ...rich(series.name));

/// Buttons above a picture: [text, what it does, words].
export const toolbar = (title, buttons) => element("span", { className: "chart-tools", role: "group",
  "aria-label": `Plot: ${title}` }, buttons.map(([name, act, title]) => button(name, act, { title })));

export class Chart {
  /// `colours()`: soft, grid and isDark. `words`: of a place without a plot. `more`: an element among the buttons.
  constructor({ colours, title = "", words = "", more = null }) {
    Object.assign(this, { colours, title, more, plot: null, chart: null, view: null });
    this.canvas = element("div", { className: "chart-canvas", role: "img" });
    this.tip = element("div", { className: "chart-tip", hidden: true });
    this.legend = element("ul", { className: "chart-legend" });
    this.none = element("p", { className: "note", textContent: words });
    this.whole = button("Whole", () => this.reset(), { title: "Show the whole range again" });
    this.head = element("div", { className: "chart-head" });
    [this.above, this.below] = ["", " below"].map((kind) => element("div", { className: `chart-label${kind}` }));
    this.root = element("div", { className: "chart" }, this.head, this.legend, this.above, this.canvas, this.below, this.none);
    this.canvas.addEventListener("dblclick", () => this.reset());
    new ResizeObserver(() => this.fit()).observe(this.canvas);
    this.clear();
  }

  /// Shows a plot as the program describes it (web/README.md, "Pictures"); the zoom stays if the axes do.
  show(plot) {
    const axes = JSON.stringify([plot.title, plot.x.label, plot.x.log, plot.y.label, plot.y.log]);
    const same = this.plot && axes === this.axes;
    if (same) for (const key of ["x", "y"]) plot[key].log = this.plot[key].log; // as chosen
    const stays = same && !this.whole.hidden;
    Object.assign(this, { plot, axes });
    this.canvas.setAttribute("aria-label", this.description());
    this.above.replaceChildren(...rich(plot.y.label));
    this.below.replaceChildren(...rich(plot.x.label));
    this.present(true);
    if (!same) this.head.replaceChildren(element("strong", {}, rich(plot.title)), this.tools());
    if (stays) this.chart?.redraw();
    else if (same && this.chart) this.rescale();
    else this.reset();
  }

  /// There is nothing to draw.
  clear() {
    this.chart?.destroy();
    Object.assign(this, { plot: null, chart: null, view: null, axes: null });
    this.head.replaceChildren(element("strong", {}, rich(this.title)));
    this.present(false);
  }

  present(some) {
    for (const each of [this.canvas, this.legend, this.above, this.below]) each.hidden = !some;
    this.none.hidden = some;
  }

  description() {
    const [x, y] = ["x", "y"].map((key) => `${plain(this.plot[key].label)} from ${limits(this.plot, key).map(short).join(" to ")}`);
    const names = this.plot.series.map(({ name }) => plain(name)).filter(Boolean);
    return `${plain(this.plot.title)}: ${y} over ${x}. ${names.length > 0 ? `Series: ${names.join(", ")}.` : ""}`;
  }

  tools() {
    const name = fileName(this.plot.title);
    const logs = ["x", "y"].filter((key) => mayBeLog(this.plot, key)).map((key) => {
      const made = button(`log ${key}`, () => {
        this.plot[key].log = !this.plot[key].log;
        made.setAttribute("aria-pressed", this.plot[key].log);
        this.reset();
      }, { title: `Logarithmic ${key} axis` });
      made.setAttribute("aria-pressed", this.plot[key].log);
      return made;
    });
    const made = toolbar(plain(this.plot.title), [
      ["CSV", () => download(`${name}.csv`, csv(this.plot), "text/csv"), "Save the numbers"],
      ["PNG", () => picture(this.plot, this.chart.ctx.canvas, this.colours().isDark, devicePixelRatio)
        .toBlob((drawn) => save(`${name}.png`, drawn)), "Save the picture as shown"],
      ["SVG", () => download(`${name}.svg`, printed(this.plot, this.view), "image/svg+xml"), "Save the picture for print"]]);
    made.prepend(...[this.more, this.whole].filter(Boolean), ...logs);
    return made;
  }

  reset() {
    this.view = null;
    this.make();
  }

  /// Draws other numbers on the same axes, as while a run is computed.
  rescale() {
    this.view = { x: limits(this.plot, "x"), y: limits(this.plot, "y") };
    const { view, chart } = this;
    chart.batch(() => ["x", "y"].forEach((key) => chart.setScale(key, { min: view[key][0], max: view[key][1] })));
    chart.redraw();
    this.showLegend();
  }

  showLegend() {
    const { isDark } = this.colours();
    this.legend.replaceChildren(...this.plot.series.filter(({ name }) => name)
      .map((series) => legendEntry(series, isDark)));
  }

  fit() {
    const width = this.canvas.clientWidth;
    if (width === 0 || !this.plot || this.chart?.width === width) return;
    if (this.chart) this.chart.setSize({ width, height: this.height(width) });
    else this.make();
  }

  height(width) {
    return Math.round(Math.min(Math.max(width * (this.plot.shape ?? 0.5), 230), 420));
  }

  /// Draws the plot anew: at the start, in other colours, with another axis.
  make() {
    const width = this.canvas.clientWidth;
    if (width === 0 || !this.plot) return;
    const { x, y } = this.plot, colours = this.colours();
    this.view ??= { x: limits(this.plot, "x"), y: limits(this.plot, "y") };
    const [left, ...right] = this.view.x;
    this.chart?.destroy();
    const scale = ({ log }, key) => ({ time: false, distr: log ? 3 : 1, range: (_, least, most) =>
      least === null ? this.view[key] : [least, most], min: this.view[key][0], max: this.view[key][1], auto: false });
    this.chart = new uPlot({ width, height: this.height(width), padding: [8, 18, 0, 0],
      axes: [axis(colours, x.log, 30, 64), axis(colours, y.log, 58, 30)],
      scales: { x: scale(x, "x"), y: scale(y, "y") }, series: [{}, { show: false }],
      hooks: { draw: [(chart) => this.draw(chart)], setCursor: [(chart) => this.tell(chart)],
        setScale: [(chart) => this.zoomed(chart)] },
      cursor: { y: false, points: { show: false }, bind: { dblclick: () => null }, drag: { x: true, y: true, uni: 30, dist: 6 } },
      legend: { show: false } }, [[left, ...right], [null, null]], this.canvas);
    this.canvas.append(this.tip);
    this.showLegend();
    this.whole.hidden = this.isWhole(this.chart);
  }

  isWhole({ scales }) {
    const whole = { x: limits(this.plot, "x"), y: limits(this.plot, "y") };
    return ["x", "y"].every((key) => Math.abs(scales[key].min - whole[key][0]) + Math.abs(scales[key].max - whole[key][1])
      <= 1e-9 * (Math.abs(whole[key][0]) + Math.abs(whole[key][1])));
  }

  zoomed(chart) {
    const { x, y } = chart.scales;
    if (!Number.isFinite(x.min) || !Number.isFinite(y.min)) return;
    this.view = { x: [x.min, x.max], y: [y.min, y.max] };
    this.whole.hidden = this.isWhole(chart);
  }

  draw(chart) {
    const { ctx: pen, bbox: box } = chart;
    const place = (x, y) => [chart.valToPos(x, "x", true), chart.valToPos(y, "y", true)];
    pen.save();
    pen.beginPath();
    pen.rect(box.left, box.top - 4, box.width, box.height + 8);
    pen.clip();
    const { isDark } = this.colours();
    for (const series of this.plot.series) drawSeries(pen, series, { place, box, scale: devicePixelRatio, isDark });
    pen.restore();
  }

  tell(chart) {
    const { left, top } = chart.cursor;
    const place = (x, y) => [chart.valToPos(x, "x"), chart.valToPos(y, "y")];
    const found = left >= 0 && left <= chart.over.clientWidth
      ? nearest(this.plot, place, { x: left, y: top }, chart.posToVal(left, "x")) : [];
    this.tip.hidden = found.length === 0;
    if (this.tip.hidden) return;
    const [{ series, i }] = found, { isDark } = this.colours();
    this.tip.replaceChildren(element("div", { className: "at" }, at(series, i)),
      ...found.map(({ series: one, i: k }) => element("div", {},
        element("span", { className: "swatch", style: `color:${colourOf(one, isDark)}` }),
        valueText(one, k), one.name ? element("span", { className: "of" }, rich(` ${one.name}`)) : [])));
    this.moveTip(chart, chart.over.offsetLeft + left, top);
  }

  /// Beside the pointer, in the other half of the height.
  moveTip({ over }, x, y) {
    const { offsetWidth: width, offsetHeight: height } = this.tip;
    const left = x + width + 16 < this.canvas.clientWidth ? x + 12 : x - width - 12;
    const top = y > over.clientHeight / 2 ? 8 : over.clientHeight - height;
    this.tip.style.translate = `${Math.max(0, left)}px ${top}px`;
  }
}
