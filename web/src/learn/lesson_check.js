// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// "Check it yourself": computes the cases of a lesson and shows their numbers.

import { button, element } from "../dom.js";
import { quantityText } from "../format.js";
import { Sweep } from "../run/sweep.js";
import { quantityName, text } from "../text/text.js";

/// The value as a bar, and its interval as a line upon it; `most`: what the whole width means.
function bar({ value, ci95 }, most) {
  const percent = (part) => `${most > 0 ? Math.min(Math.max(0, (100 * part) / most), 100) : 0}%`;
  const amount = element("div", { className: "amount" }), interval = element("div", { className: "interval" });
  amount.style.width = percent(value);
  interval.hidden = !(ci95 > 0);
  interval.style.left = percent(value - ci95);
  interval.style.right = `calc(100% - ${percent(value + ci95)})`;
  return element("div", { className: "bar" }, amount, interval);
}

export class LessonCheck {
  /// `words`: those of the lesson. `page`: the Page.
  constructor({ lesson, words, toml, page }) {
    Object.assign(this, { lesson, words, toml, page });
    this.go = button(text.lessonCheck, () => this.toggle(), { className: "primary" });
    this.progress = element("progress", { max: 1, value: 0, hidden: true, "aria-label": text.lessonCheck });
    this.status = element("p", { className: "note", "aria-live": "polite", textContent: text.lessonCheckAbout });
    this.table = element("div");
    this.conclusion = element("p", { className: "conclusion", hidden: true, textContent: words.conclusion });
    this.root = element("div", { className: "lesson-check" }, this.go, this.progress, this.status, this.table,
      this.conclusion);
  }

  toggle() {
    if (this.sweep?.status === "computing") return this.sweep.stop();
    this.ended = this.compute();
  }

  /// Resolves when nothing is computed any more.
  stop() {
    this.sweep?.stop();
    return this.ended;
  }

  /// The run of the page is stopped; a sweep of the page is not.
  async compute() {
    if (this.page.active()) await this.page.stopped();
    if (this.page.sweeping || this.page.active()) {
      this.status.textContent = text.sweepWaits;
      return;
    }
    this.page.busy(true);
    try {
      const { replicates } = await this.page.inspector.call("check", this.toml, []);
      this.sweep = new Sweep(this.page.pool, this.page.inspector, { toml: this.toml, replicates,
        points: this.lesson.points.map((point) => ({ ...point })) }, () => this.show());
      await this.sweep.start();
    } finally {
      this.page.busy(false);
    }
  }

  show() {
    const { status, points, at } = this.sweep, computing = status === "computing";
    this.go.textContent = computing ? text.stop : text.lessonCheck;
    this.progress.hidden = !computing;
    this.progress.value = this.sweep.share();
    this.status.textContent = computing ? text.lessonStatus(Math.min(at + 1, points.length), points.length)
      : text.sweepStatus(status, Math.min(at, points.length), points.length);
    this.conclusion.hidden = status !== "done";
    const done = points.filter(({ summary, fault }) => summary || fault);
    if (done.length === this.shown) return;
    this.shown = done.length;
    this.table.replaceChildren(...(done.length > 0 ? [this.rows(done)] : []));
  }

  /// The quantities below each other, each with a row for every case.
  rows(points) {
    return element("table", {}, element("caption", { className: "for-readers", textContent: text.lessonResult }),
      this.lesson.quantities.map((key) => {
        const values = points.map(({ summary }) => summary?.[key] ?? { value: null });
        const most = Math.max(...values.map(({ value, ci95 }) => value + (ci95 ?? 0)));
        const named = points.find(({ summary }) => summary)?.summary[key] ?? { label: key };
        return element("tbody", {}, element("tr", {},
          element("th", { scope: "rowgroup", colSpan: 2, textContent: quantityName(key, named) })),
        points.map(({ value, fault }, i) => element("tr", {}, element("th", { scope: "row", textContent: value }),
          element("td", { className: "figure" }, fault ?? quantityText(values[i]), bar(values[i], most)))));
      }));
  }
}
