// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The plots of a page that the program wrote: each <script class="plot"> becomes a chart.

import style from "./style/plot.css";
import plotStyle from "uplot/dist/uPlot.min.css";
import { Chart, toolbar } from "./plot/chart.js";
import { fileName, savePng, saveSvg } from "./plot/save.js";

const dark = matchMedia("(prefers-color-scheme: dark)");

function colours() {
  const of = getComputedStyle(document.documentElement);
  const value = (name) => of.getPropertyValue(`--${name}`).trim();
  return { soft: value("soft"), grid: value("grid"), isDark: dark.matches };
}

document.head.append(Object.assign(document.createElement("style"), { textContent: plotStyle + style }));
const charts = [...document.querySelectorAll("script.plot")].map((data) => {
  const print = data.previousElementSibling?.localName === "noscript" ? data.previousElementSibling.textContent : "";
  const chart = new Chart({ colours });
  data.replaceWith(chart.root);
  chart.show(JSON.parse(data.textContent), print.trim());
  return chart;
});
dark.addEventListener("change", () => charts.forEach((chart) => chart.make()));
for (const svg of document.querySelectorAll("figure > svg")) {
  const title = svg.getAttribute("aria-label") ?? "picture", name = fileName(title);
  const tools = toolbar(title, [["SVG", () => saveSvg(name, svg), "Save the picture"],
    ["PNG", () => savePng(name, svg), "Save the picture in pixels"]]);
  tools.classList.add("of-picture");
  svg.before(tools);
}
