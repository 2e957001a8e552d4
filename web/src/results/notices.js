// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What the program says about a result or a case: why it ended early, what may be wrong, and notes.

import { button, element } from "../dom.js";
import { text } from "../text/text.js";

const severities = ["invalid", "warning", "note"];
const endings = ["no-result", "stopped", "interrupted"]; // codes; these come first

const rankOf = ({ severity, code }) =>
  (endings.includes(code) ? 0 : 10 + severities.indexOf(severity));

/// A list of at most `most` notices, the most important first.
export function noticeList(notices, most = Infinity) {
  const sorted = [...notices].sort((a, b) => rankOf(a) - rankOf(b));
  return element("ul", { className: "notices" }, sorted.slice(0, most).map(({ severity, text: said }) =>
    element("li", { className: severity }, element("strong", {}, text.severity(severity)), ` ${said}`)));
}

/// The box above a result: its warnings in short.
export class NoticeBox {
  /// `open` shows the notices in full.
  constructor(root, open) {
    Object.assign(this, { root, open });
    this.show([]);
  }

  /// Shows those of the notices that are more than notes.
  show(notices) {
    const serious = notices.filter(({ severity }) => severity !== "note");
    const said = JSON.stringify(serious);
    if (said === this.said) return;
    this.said = said;
    this.root.hidden = serious.length === 0;
    this.root.replaceChildren(noticeList(serious, 3),
      button(text.noticesInFull(serious.length), this.open, { className: "quiet" }));
  }

  /// Shows what is known while a run is computed: which replicates were stopped, and why.
  showProgress(run) {
    this.show(run.replicates.filter(({ reason }) => reason).map(({ number, reason }) =>
      ({ severity: "warning", code: "stopped", text: text.replicateStopped(number + 1, reason) })));
  }
}
