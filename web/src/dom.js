// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Elements of the page.

/// An element. Properties are set as such; names with a dash, `role` and `for` become attributes.
export function element(name, properties = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(properties)) {
    if (value === null || value === undefined) continue;
    if (key.includes("-") || key === "role" || key === "for") made.setAttribute(key, value);
    else made[key] = value;
  }
  made.append(...children.flat().filter((child) => child !== null && child !== undefined));
  return made;
}

export const button = (text, onclick, properties = {}) =>
  element("button", { type: "button", textContent: text, onclick, ...properties });

let made = 0;

/// An id that no other element has.
export const freshId = (stem) => `${stem}-${++made}`;

/// Calls `act` once, `wait` milliseconds after the last call.
export function later(act, wait) {
  let timer = 0;
  return (...values) => {
    clearTimeout(timer);
    timer = setTimeout(() => act(...values), wait);
  };
}

/// Buttons of which one is pressed. Calls `pick(key)`.
export function choice(label, options, chosen, pick) {
  const show = (key) => buttons.forEach((each) =>
    each.setAttribute("aria-pressed", String(each.dataset.key === key)));
  const buttons = options.map(({ key, name, about }) => {
    const each = button(name, () => (show(key), pick(key)), { title: about ?? "" });
    each.dataset.key = key;
    return each;
  });
  show(chosen);
  return element("div", { className: "choice", role: "group", "aria-label": label }, buttons);
}

/// Copies a text to the clipboard. Returns whether the browser allowed it.
export async function copied(text) {
  try {
    await navigator.clipboard.writeText(text);
    return true;
  } catch {
    return false;
  }
}

/// Saves a text as a file.
export const download = (name, text, type = "text/plain") =>
  save(name, new Blob([text], { type: `${type};charset=utf-8` }));

/// Saves a blob as a file.
export function save(name, content) {
  const link = element("a", { download: name, href: URL.createObjectURL(content) });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 60e3);
}
