// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The words of plots. Symbols in labels: "$E_{n}$" is an italic E with the subscript n, "f^{2}" a superscript.

import { short } from "../format.js";

export const marks = /\$([^$]*)\$|_\{([^}]*)\}|\^\{([^}]*)\}/g;
const styled = (tag, text) => Object.assign(document.createElement(tag), { textContent: text });

/// Nodes of a label.
export function rich(text) {
  const nodes = [];
  let from = 0;
  for (const found of text.matchAll(marks)) {
    if (found.index > from) nodes.push(text.slice(from, found.index));
    const [whole, italic, below, above] = found;
    if (italic !== undefined) {
      const symbol = document.createElement("i");
      symbol.append(...rich(italic));
      nodes.push(symbol);
    } else nodes.push(styled(below !== undefined ? "sub" : "sup", below ?? above));
    from = found.index + whole.length;
  }
  if (from < text.length) nodes.push(text.slice(from));
  return nodes;
}

/// The label without marks.
export const plain = (text) => text.replace(/\$|[_^]\{|\}/g, "");

/// "0.5 to 1" of a bin, else the number itself.
export const at = ({ mark, x }, i) => (mark === "steps" ? `${short(x[i])} to ${short(x[i + 1])}` : short(x[i]));

/// "12 (10 to 14)".
export function valueText({ y, low, high }, i) {
  const value = Number.isFinite(y[i]) ? short(y[i]) : "–";
  return Number.isFinite(low?.[i]) ? `${value} (${short(low[i])} to ${short(high[i])})` : value;
}
