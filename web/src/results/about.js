// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// "About these numbers": notices, assumed and unverified values, and how to repeat the run.

import { button, element } from "../dom.js";
import { text } from "../text/text.js";
import { noticeList } from "./notices.js";

function originsTable(origins, label) {
  return element("div", { className: "scroll", tabIndex: 0, role: "region", "aria-label": label },
    element("table", { className: "origins" },
      element("thead", {}, element("tr", {}, ...text.originColumns.map((name) =>
        element("th", { scope: "col", textContent: name })))),
      element("tbody", {}, origins.map(({ key, value, source }) => element("tr", {},
        element("th", { scope: "row" }, element("code", { textContent: key })),
        element("td", { className: "figure", textContent: value }),
        element("td", { className: "about", textContent: source }))))));
}

function part(title, count, open, ...content) {
  return element("details", { open }, element("summary", {},
    element("span", { textContent: title }),
    count === null ? null : element("span", { className: "count", textContent: count })), ...content);
}

const uncalibrated = ({ source }) => /uncalibrated|not calibrated/.test(source);

export class About {
  constructor(root, downloadCase) {
    this.root = root;
    this.downloadCase = downloadCase;
  }

  /// `checked`: the check of the case. `notices`: those of the result, or of the check.
  show(checked, notices) {
    const origins = checked.origins ?? [];
    const assumed = origins.filter((each) => each.assumed);
    const unverified = origins.filter((each) => each.unverified);
    const guessed = assumed.filter(uncalibrated);
    this.root.replaceChildren(
      element("p", { textContent: text.trust }),
      notices.length > 0 ? noticeList(notices)
        : element("p", { className: "note", textContent: text.noNotices }),
      guessed.length > 0 ? element("p", { className: "callout" }, element("strong", {}, text.guessed),
        ` ${guessed.map(({ key, value }) => `${key} = ${value}`).join(", ")}`) : null,
      part(text.unverified, unverified.length, unverified.length > 0,
        element("p", { className: "note", textContent: text.unverifiedAbout }),
        unverified.length > 0 ? originsTable(unverified, text.unverified) : null),
      part(text.assumed, assumed.length, false,
        element("p", { className: "note", textContent: text.assumedAbout }),
        originsTable(assumed, text.assumed)),
      part(text.repeat, null, true, ...this.command()));
  }

  command() {
    const line = "mahlwerk run case.toml";
    const copy = button(text.copy, async () => {
      await navigator.clipboard?.writeText(line).catch(() => {});
      copy.textContent = text.copied;
      setTimeout(() => (copy.textContent = text.copy), 2000);
    }, { className: "quiet" });
    return [element("p", { textContent: text.repeatAbout }),
      element("div", { className: "command" }, element("code", { textContent: line }), copy,
        button(text.downloadCase, this.downloadCase, { className: "quiet" }))];
  }
}
