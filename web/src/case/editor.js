// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The case as text, with line numbers, colours and faults at their lines.

import { button, element } from "../dom.js";
import { text } from "../text/text.js";

const rules = [
  ["comment", /^#[^]*/],
  ["section", /^\[\[?[^\]\n]*\]\]?/],
  ["string", /^"(?:[^"\\\n]|\\.)*"?|^'[^'\n]*'?/],
  ["number", /^[+-]?\d[\d_.e+-]*\b/],
  ["key", /^[A-Za-z0-9_.-]+(?=[ \t]*=)/],
  ["plain", /^[A-Za-z0-9_]+|^[ \t]+|^[^]/],
];

/// The pieces of a line, coloured.
function coloured(line) {
  const pieces = [];
  for (let rest = line; rest !== "";) {
    const [name, [piece]] = rules.map(([kind, rule]) => [kind, rest.match(rule)])
      .find(([, found]) => found);
    pieces.push(name === "plain" ? piece : element("span", { className: name, textContent: piece }));
    rest = rest.slice(piece.length);
  }
  return pieces;
}

export class Editor {
  constructor(root, store) {
    Object.assign(this, { root, store, faults: [] });
    this.lines = element("div", { className: "lines", "aria-hidden": "true" });
    this.area = element("textarea", { id: "case-text", spellcheck: false, wrap: "off",
      autocapitalize: "off", autocomplete: "off", "aria-label": text.caseText,
      "aria-describedby": "case-faults", oninput: () => this.typed(), onscroll: () => this.follow() });
    this.list = element("ul", { className: "faults", id: "case-faults", "aria-live": "polite" });
    root.append(element("div", { className: "editor" }, this.lines, this.area), this.list);
    store.addEventListener("text", () => this.show());
    store.addEventListener("checked", ({ detail }) => this.showFaults(detail.faults));
  }

  typed() {
    this.store.setText(this.area.value, "editor");
  }

  show() {
    if (this.area.value !== this.store.text) this.area.value = this.store.text;
    this.paint();
  }

  paint() {
    const faulty = new Set(this.faults.map(({ line }) => line));
    this.lines.replaceChildren(...this.store.text.split("\n").map((line, i) =>
      element("div", { className: faulty.has(i + 1) ? "line faulty" : "line" }, coloured(line))));
    this.follow();
  }

  follow() {
    this.lines.style.transform = `translate(${-this.area.scrollLeft}px, ${-this.area.scrollTop}px)`;
  }

  showFaults(faults) {
    this.faults = faults;
    this.area.setAttribute("aria-invalid", String(faults.length > 0));
    this.list.replaceChildren(...faults.map((fault) => element("li", {},
      fault.line > 0
        ? button(text.lineNumber(fault.line), () => this.goTo(fault), { className: "quiet place" })
        : null,
      element("span", {}, fault.text),
      fault.remedy ? element("span", { className: "remedy" }, text.remedy(fault.remedy)) : null)));
    this.paint();
  }

  /// Puts the caret at a fault.
  goTo({ line, column }) {
    const rows = this.store.text.split("\n");
    const start = rows.slice(0, line - 1).reduce((sum, row) => sum + row.length + 1, 0);
    const from = start + Math.max((column || 1) - 1, 0);
    this.area.focus();
    this.area.setSelectionRange(from, start + (rows[line - 1]?.length ?? 0));
    const height = this.area.scrollHeight / rows.length;
    this.area.scrollTop = Math.max(0, (line - 4) * height);
  }
}
