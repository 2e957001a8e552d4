// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A plot of the page, drawn as in reports, in the colours of the page.

import { element } from "../dom.js";
import { Chart } from "../plot/chart.js";
import { text } from "../text/text.js";
import { isDark, onTheme } from "../theme.js";

function colours() {
  const of = getComputedStyle(document.documentElement);
  return { soft: of.getPropertyValue("--soft").trim(), grid: of.getPropertyValue("--grid").trim(), isDark: isDark() };
}

/// A Chart in a figure, `root`. `more`: an element among its buttons.
export function pageChart(title, more = null) {
  const chart = new Chart({ colours, title, words: text.noCurve, more });
  chart.figure = element("figure", { className: "plot-figure" }, chart.root);
  onTheme(() => chart.plot && chart.make());
  return chart;
}

/// A line of a plot in the form of the program's: null where there is no value.
export const line = (name, x, y, more = {}) => ({ name, mark: "line", colour: 0, band: false, x, y, ...more });
