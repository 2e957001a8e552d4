// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Colours of balls and of the page's two themes.

import { Color } from "three";
import { viridis } from "./viridis.js";

// Okabe and Ito, in the order of the report's plots.
export const speciesColours = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9",
  "#F0E442", "#666666"];

/// Colours of a quantity, from 0 to the top of its scale.
export const gradient = viridis;

const steps = 256;

/// Linear red, green, blue of `steps` values from 0 to the top of the scale.
const table = (() => {
  const list = new Float32Array(3 * steps);
  for (let i = 0; i < steps; ++i) {
    const at = (i / (steps - 1)) * (viridis.length - 1);
    const low = Math.min(Math.floor(at), viridis.length - 2);
    new Color(viridis[low]).lerp(new Color(viridis[low + 1]), at - low).toArray(list, 3 * i);
  }
  return list;
})();

/// Writes the colour of a part of the scale into a list.
export function colourAt(part, list, at) {
  const i = 3 * Math.min(steps - 1, Math.max(0, Math.round(part * (steps - 1))));
  list[at] = table[i];
  list[at + 1] = table[i + 1];
  list[at + 2] = table[i + 2];
}

const light = { ink: "#1d2329", soft: "#59636e", grid: "#e3e6ea", paper: "#ffffff", box: "#f5f7f9",
  edge: "#d5dae0" };
const dark = { ink: "#e4e8ec", soft: "#a3adb8", grid: "#30363d", paper: "#14181c", box: "#1d2329",
  edge: "#39424b" };

/// Colours that are not variables of the page: wall, stripes and lines of the jar, parts, disc.
const wallsOf = (isDark) => isDark
  ? { wall: "#56636f", stripe: "#45515d", mark: "#e0913a", line: "#a9b8c8", part: "#8b98a6",
      glass: "#9fb4c8", disc: "#2b333c" }
  : { wall: "#cbd5df", stripe: "#b4c1ce", mark: "#e0782a", line: "#5d6b7a", part: "#9aa7b4",
      glass: "#5f7f9f", disc: "#e6ebf0" };

/// Theme of prints: light on white, independent of the theme of the screen.
export const printTheme = { ...light, box: "#ffffff", ...wallsOf(false), dark: false };

/// The current theme: that of the page's `data-theme`, otherwise that of the system. Variables of the
/// page have precedence over the default colours.
export function themeOf(element) {
  const chosen = document.documentElement.dataset.theme;
  const isDark = chosen ? chosen === "dark" : matchMedia("(prefers-color-scheme: dark)").matches;
  const theme = { ...(isDark ? dark : light), ...wallsOf(isDark), dark: isDark };
  const style = getComputedStyle(element);
  for (const name of Object.keys(light)) {
    const value = style.getPropertyValue(`--${name}`).trim();
    if (value && CSS.supports("color", value)) theme[name] = value;
  }
  return theme;
}
