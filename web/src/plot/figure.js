// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A map or bars on a page: the picture at the width of the page, what stands under the pointer, and what can be saved.

import { download, element } from "../dom.js";
import { barRows, drawBars } from "./bars.js";
import { toolbar } from "./chart.js";
import { drawMap, mapRows } from "./map.js";
import { csvOf, fileName, savePng } from "./save.js";
import { inPrint } from "./svg.js";
import { plain, rich } from "./words.js";

const kinds = { map: { draw: drawMap, rows: mapRows }, bars: { draw: drawBars, rows: barRows } };
const printWidth = 900; // px

export class Figure {
  /// `colours()`: soft, grid, ink and isDark.
  constructor(picture, colours) {
    Object.assign(this, { picture, colours, ...kinds[picture.kind] });
    this.canvas = element("div", { className: "figure-canvas" });
    this.tip = element("div", { className: "chart-tip", hidden: true });
    this.root = element("div", { className: "chart" },
      element("div", { className: "chart-head" }, element("strong", {}, rich(picture.title)), this.tools()),
      element("div", { className: "figure-frame" }, this.canvas, this.tip));
    this.canvas.addEventListener("pointermove", (event) => this.tell(event));
    this.canvas.addEventListener("pointerdown", (event) => this.tell(event));
    this.canvas.addEventListener("pointerleave", () => (this.tip.hidden = true));
    new ResizeObserver(() => this.fit()).observe(this.canvas);
  }

  tools() {
    const name = fileName(this.picture.title);
    return toolbar(plain(this.picture.title), [
      ["CSV", () => download(`${name}.csv`, csvOf(this.rows(this.picture)), "text/csv"), "Save the numbers"],
      ["PNG", () => savePng(name, this.printed()), "Save the picture in pixels"],
      ["SVG", () => download(`${name}.svg`, this.printed(), "image/svg+xml"), "Save the picture for print"]]);
  }

  printed() {
    return this.draw(this.picture, printWidth, inPrint).svg;
  }

  fit() {
    if (this.canvas.clientWidth !== this.width) this.make();
  }

  make() {
    this.width = this.canvas.clientWidth;
    if (this.width === 0) return;
    this.drawn = this.draw(this.picture, this.width, this.colours());
    this.canvas.innerHTML = this.drawn.svg; // escaped in svg.js
  }

  tell(event) {
    const place = this.canvas.getBoundingClientRect();
    const [x, y] = [event.clientX - place.left, event.clientY - place.top];
    const said = this.drawn?.tell(x, y);
    this.tip.hidden = !said;
    if (!said) return;
    this.tip.replaceChildren(element("div", {}, said.value), element("div", { className: "at" }, said.at));
    const { offsetWidth: width, offsetHeight: height } = this.tip;
    const left = x + width + 16 < this.width ? x + 14 : x - width - 14;
    this.tip.style.translate = `${Math.max(0, left)}px ${Math.max(0, y - height - 10)}px`;
  }
}
