// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Which lessons have been answered. The browser keeps it; where it keeps nothing, it is known until the page is left.

const key = "mahlwerk-lessons";

export class Progress {
  constructor() {
    this.done = new Set();
    try {
      for (const name of JSON.parse(localStorage.getItem(key)) ?? []) this.done.add(String(name));
    } catch {
      // no storage, or what it holds is of something else
    }
  }

  has(name) {
    return this.done.has(name);
  }

  add(name) {
    this.done.add(name);
    try {
      localStorage.setItem(key, JSON.stringify([...this.done]));
    } catch {
      // no storage
    }
  }
}
