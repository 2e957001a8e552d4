// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The pictures of a page that the program wrote: each <script class="picture"> becomes a chart, a map or bars.

import style from "./style/plot.css";
import plotStyle from "uplot/dist/uPlot.min.css";
import { Chart } from "./plot/chart.js";
import { Figure } from "./plot/figure.js";

const dark = matchMedia("(prefers-color-scheme: dark)");

function colours() {
  const of = getComputedStyle(document.documentElement);
  const value = (name) => of.getPropertyValue(`--${name}`).trim();
  return { soft: value("soft"), grid: value("grid"), ink: value("ink"), isDark: dark.matches };
}

function show(data) {
  const picture = JSON.parse(data.textContent), { kind = "plot" } = picture; // once there were only plots
  const shown = kind === "plot" ? new Chart({ colours }) : new Figure(picture, colours);
  data.replaceWith(shown.root);
  if (kind === "plot") shown.show(picture);
  return shown;
}

document.head.append(Object.assign(document.createElement("style"), { textContent: plotStyle + style }));
const pictures = [...document.querySelectorAll("script.picture, script.plot")].map(show);
dark.addEventListener("change", () => pictures.forEach((each) => each.make()));
