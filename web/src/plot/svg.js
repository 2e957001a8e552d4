// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Pictures as SVG texts: maps and bars on the page, and every picture that is saved.

import { marks } from "./words.js";

const letter = 6.6; // px: mean width of a letter of 12 px
const number = (value) => String(Math.round(value * 100) / 100);
const escaped = (text) => String(text).replace(/[&<>"]/g, (each) => `&#${each.charCodeAt(0)};`);

/// Colours on white ground, for print.
export const inPrint = { soft: "#59636e", grid: "#e3e6ea", ink: "#1d2329", ground: "#fff", isDark: false };

/// Width of a text of 12 px [px].
export const widthOf = (text) => letter * [...text.replace(/\$|[_^]\{|\}/g, "")].length;

/// The text in lines that are at most `width` wide [px]; a longer word has a line of its own.
export function wrapped(text, width) {
  const lines = [];
  for (const word of text.split(" ").filter(Boolean)) {
    const longer = lines.length > 0 ? `${lines.at(-1)} ${word}` : word;
    if (lines.length > 0 && widthOf(longer) <= width) lines[lines.length - 1] = longer;
    else lines.push(word);
  }
  return lines;
}

/// The parts of a label in one style: [words, attributes, how far they are raised (px)].
function runs(text, style = "") {
  const list = [];
  let from = 0;
  for (const found of text.matchAll(marks)) {
    const [whole, italic, below, above] = found;
    list.push([text.slice(from, found.index), style, 0]);
    if (italic !== undefined) list.push(...runs(italic, ' font-style="italic"'));
    else list.push([below ?? above, ' font-size="9"', below !== undefined ? -2.6 : 4.3]);
    from = found.index + whole.length;
  }
  return [...list, [text.slice(from), style, 0]].filter(([words]) => words);
}

/// The label as content of a <text>.
function spans(text) {
  let raised = 0;
  return runs(text).map(([words, style, to]) => {
    const shift = to === raised ? "" : ` dy="${number(raised - to)}"`;
    raised = to;
    return style || shift ? `<tspan${style}${shift} xml:space="preserve">${escaped(words)}</tspan>` : escaped(words);
  }).join("");
}

/// Collects the elements of a picture.
export class Svg {
  constructor(colours) {
    this.colours = colours;
    this.parts = [];
  }

  text(x, y, words, { anchor = "start", fill = this.colours.soft, more = "" } = {}) {
    this.parts.push(`<text x="${number(x)}" y="${number(y)}" text-anchor="${anchor}" fill="${fill}"${more}>${spans(words)}</text>`);
  }

  /// Upright beside a vertical axis.
  upright(x, y, words) {
    this.text(x, y, words, { anchor: "middle", fill: this.colours.ink, more: ` transform="rotate(-90 ${number(x)} ${number(y)})"` });
  }

  path(d, style) {
    this.parts.push(`<path d="${d}" ${style}/>`);
  }

  rect(x, y, width, height, style) {
    this.parts.push(`<rect x="${number(x)}" y="${number(y)}" width="${number(width)}" height="${number(height)}" ${style}/>`);
  }

  /// A whole picture: with a title and a ground if it is saved.
  drawn(width, height, title) {
    const { ground, ink } = this.colours;
    const size = `viewBox="0 0 ${number(width)} ${number(height)}" width="${number(width)}" height="${number(height)}"`;
    return `<svg xmlns="http://www.w3.org/2000/svg" ${size} role="img" aria-label="${escaped(title)}" font-size="12" ` +
      `font-family="Helvetica,Arial,Liberation Sans,DejaVu Sans,sans-serif" fill="${ink}">\n` +
      `${ground ? `<rect width="100%" height="100%" fill="${ground}"/>\n` : ""}${this.parts.join("\n")}\n</svg>\n`;
  }
}

/// What draw.js needs of the context of a canvas, written into an Svg.
export class SvgPen {
  constructor(svg) {
    Object.assign(this, { svg, d: "", strokeStyle: "#000", fillStyle: "#000", lineWidth: 1, globalAlpha: 1, dash: [], kept: [] });
  }

  save() {
    const { strokeStyle, fillStyle, lineWidth, globalAlpha, dash } = this;
    this.kept.push({ strokeStyle, fillStyle, lineWidth, globalAlpha, dash });
  }

  restore() {
    Object.assign(this, this.kept.pop());
  }

  setLineDash(dash) {
    this.dash = dash;
  }

  beginPath() {
    this.d = "";
  }

  closePath() {
    this.d += "z";
  }

  moveTo(x, y) {
    this.d += `M${number(x)} ${number(y)}`;
  }

  lineTo(x, y) {
    this.d += `L${number(x)} ${number(y)}`;
  }

  rect(x, y, width, height) {
    this.d += `M${number(x)} ${number(y)}h${number(width)}v${number(height)}h${number(-width)}z`;
  }

  /// Whole circles only.
  arc(x, y, radius) {
    this.d += `M${number(x - radius)} ${number(y)}a${radius} ${radius} 0 1 0 ${number(2 * radius)} 0a${radius} ${radius} 0 1 0 ${number(-2 * radius)} 0z`;
  }

  fill() {
    this.svg.path(this.d, `fill="${this.fillStyle}" fill-opacity="${this.globalAlpha}"`);
  }

  stroke() {
    const dash = this.dash.length > 0 ? ` stroke-dasharray="${this.dash.join(" ")}"` : "";
    this.svg.path(this.d, `fill="none" stroke="${this.strokeStyle}" stroke-width="${number(this.lineWidth)}" stroke-linejoin="round"${dash}`);
  }
}
