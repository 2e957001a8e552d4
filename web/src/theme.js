// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Dark and light: as the system, or as chosen on the page.

const key = "mahlwerk-theme";
const dark = matchMedia("(prefers-color-scheme: dark)");
const listeners = [];

function stored() {
  try {
    return localStorage.getItem(key);
  } catch {
    return null; // pages from disk may have no storage
  }
}

export const isDark = () => document.documentElement.dataset.theme === "dark";

function apply() {
  document.documentElement.dataset.theme = stored() ?? (dark.matches ? "dark" : "light");
  listeners.forEach((listener) => listener());
}

export function onTheme(listener) {
  listeners.push(listener);
}

export function toggleTheme() {
  const theme = isDark() ? "light" : "dark";
  try {
    if ((theme === "dark") === dark.matches) localStorage.removeItem(key);
    else localStorage.setItem(key, theme);
  } catch {
    document.documentElement.dataset.theme = theme;
    listeners.forEach((listener) => listener());
    return;
  }
  apply();
}

dark.addEventListener("change", apply);
apply();
