// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tabs: a list of buttons and their panels, with the keys of such lists.

import { element } from "./dom.js";

export class Tabs {
  /// `tabs`: list of { key, name }. `panels` maps keys to elements.
  constructor(label, tabs) {
    this.panels = {};
    this.buttons = tabs.map(({ key, name }) => {
      const tab = element("button", { type: "button", id: `tab-${key}`, role: "tab",
        "aria-controls": `panel-${key}`, onclick: () => this.choose(key) },
      element("span", { textContent: name }));
      tab.dataset.key = key;
      this.panels[key] = element("div", { id: `panel-${key}`, className: `panel panel-${key}`,
        role: "tabpanel", "aria-labelledby": `tab-${key}` });
      return tab;
    });
    this.list = element("div", { className: "tabs", role: "tablist", "aria-label": label,
      onkeydown: (event) => this.key(event) }, this.buttons);
    this.choose(tabs[0].key);
  }

  choose(key) {
    this.chosen = key;
    for (const tab of this.buttons) {
      const mine = tab.dataset.key === key;
      tab.setAttribute("aria-selected", String(mine));
      tab.tabIndex = mine ? 0 : -1;
      this.panels[tab.dataset.key].classList.toggle("chosen", mine);
    }
  }

  key(event) {
    const at = this.buttons.findIndex((tab) => tab.dataset.key === this.chosen);
    const last = this.buttons.length - 1;
    const to = { ArrowRight: at === last ? 0 : at + 1, ArrowLeft: at === 0 ? last : at - 1, Home: 0,
      End: last }[event.key];
    if (to === undefined) return;
    event.preventDefault();
    this.choose(this.buttons[to].dataset.key);
    this.buttons[to].focus();
  }

  /// A number or a mark behind the name of a tab; "" removes it.
  badge(key, mark, about = "") {
    const tab = this.buttons.find((each) => each.dataset.key === key);
    tab.querySelector(".badge")?.remove();
    if (mark !== "") tab.append(element("span", { className: "badge", textContent: mark, title: about }));
  }
}
