// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The tab "History": opens, names, saves, deletes and downloads results and cases, and takes two for the comparison.

import { button, download, element, freshId } from "../dom.js";
import { quantityText } from "../format.js";
import { shortList } from "../results/quantities.js";
import { quantityName, text } from "../text/text.js";

const fileName = (name, ending) =>
  `${name.toLowerCase().replace(/[^\p{L}\p{N}.]+/gu, "-").replace(/^-|-$/g, "") || "case"}${ending}`;

const quantities = new WeakMap(); // entry -> its first key numbers

/// The first key numbers of a result, in a line.
function numbersOf(entry) {
  if (!entry.summary) return text.onlyCase;
  if (!quantities.has(entry)) {
    const summary = JSON.parse(entry.summary);
    quantities.set(entry, shortList(summary).slice(0, 3).map((key) => [key, summary[key]]));
  }
  return quantities.get(entry).map(([key, one]) => `${quantityName(key, one)} ${quantityText(one)}`).join(", ");
}

export class HistoryPanel {
  /// `actions`: open(id), caseNow() -> { name, toml, id }: the case of the page and the entry of its result or null,
  /// compare(side, id), compared() -> { a, b }: ids or null, removed(id).
  constructor(root, history, actions) {
    Object.assign(this, { root, history, actions, naming: null });
    this.name = element("input", { type: "text", id: freshId("name"), autocomplete: "off", maxLength: 120 });
    this.said = element("p", { className: "note", role: "status" });
    this.about = element("p", { className: "note" });
    this.list = element("ul", { className: "history" });
    root.append(element("form", { className: "row saving", onsubmit: (event) => (event.preventDefault(), this.saveCase()) },
      element("label", { for: this.name.id, textContent: text.nameOfCase }), this.name,
      element("button", { type: "submit", className: "primary", textContent: text.saveThisCase })),
    this.said, this.about, this.list);
    history.addEventListener("change", () => this.draw());
    this.draw();
  }

  /// The name that is offered for the case of the page.
  suggest(title) {
    this.name.placeholder = title;
  }

  async saveCase() {
    const { name, toml, id } = this.actions.caseNow();
    const wanted = this.name.value.trim() || name;
    const entry = this.history.of(id) ? id : this.history.add(wanted, toml, null);
    if (await this.tell(this.history.save(entry, wanted), text.savedAs(wanted))) this.name.value = "";
  }

  /// Says what has been done, or why it could not be. Returns whether it was done.
  async tell(work, words) {
    try {
      await work;
      this.said.textContent = words;
      return true;
    } catch (error) {
      this.said.textContent = text.notSaved(error.reason ?? error.message);
      return false;
    }
  }

  draw() {
    const { entries, available } = this.history;
    this.about.textContent = available ? text.historyAbout : text.historyDenied;
    this.list.replaceChildren(...entries.map((entry) => this.item(entry)));
    const naming = this.list.querySelector("input");
    naming?.focus();
    naming?.select();
  }

  item(entry) {
    const item = element("li", {}, element("div", { className: "head" },
      this.naming === entry.id ? this.namingForm(entry) : element("strong", { textContent: entry.name }),
      element("span", { className: "note", textContent: text.entryAbout(entry) })),
    entry.change.length > 0 ? element("p", { className: "note", textContent: text.entryChange(entry.change) }) : null,
    element("p", { className: "numbers", textContent: numbersOf(entry) }), this.buttons(entry));
    item.dataset.id = entry.id;
    return item;
  }

  namingForm(entry) {
    const name = element("input", { type: "text", value: entry.name, "aria-label": text.nameOfEntry, maxLength: 120,
      onkeydown: ({ key }) => void (key === "Escape" && this.beginNaming(null)) }); // false would stop every other key
    return element("form", { className: "row", onsubmit: (event) => {
      event.preventDefault();
      this.endNaming(entry, name.value.trim());
    } }, name, element("button", { type: "submit", textContent: text.ok }));
  }

  beginNaming(id) {
    this.naming = id;
    this.draw();
  }

  endNaming({ id, saved, name: before }, name) {
    this.naming = null;
    if (name === "" || !this.history.of(id)) return this.draw();
    if (saved && name === before) return this.draw();
    return this.tell(this.history.save(id, name), text.savedAs(name)).then(() => this.draw());
  }

  buttons(entry) {
    const { id, name } = entry;
    const named = (label, act, about) => button(label, act, { className: "quiet", "aria-label": about(name) });
    const side = (key, label) => {
      const taken = this.actions.compared()[key] === id;
      return button(label, () => this.actions.compare(key, taken ? null : id), { "aria-label": text.compareAs(label, name),
        "aria-pressed": String(taken) });
    };
    return element("div", { className: "row" }, named(text.open, () => this.actions.open(id), text.openEntry),
      named(entry.saved ? text.rename : text.saveEntry, () => this.beginNaming(id), entry.saved ? text.renameEntry
        : text.saveEntryAbout),
      named("case.toml", () => download(fileName(name, ".toml"), entry.toml, "application/toml"), text.downloadCaseOf),
      entry.summary ? named("summary.json", () => download(fileName(name, ".summary.json"), entry.summary, "application/json"),
        text.downloadSummaryOf) : null,
      named(text.delete, () => (this.actions.removed(id), this.history.remove(id)), text.deleteEntry),
      entry.summary ? element("div", { className: "choice", role: "group", "aria-label": text.compareGroup },
        side("a", "A"), side("b", "B")) : null);
  }
}
