// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A sweep: one key from a first to a last value, and the curve of a quantity over it.

import { button, download, element, freshId } from "../dom.js";
import { writeCsv } from "../csv.js";
import { multipleOf, quantityText } from "../format.js";
import { fieldsOf, kindOf, millOf } from "../case/field_list.js";
import { join } from "../case/quantity.js";
import { rangeOf } from "../case/ranges.js";
import { Sweep } from "../run/sweep.js";
import { valuesBetween } from "../run/sweep_values.js";
import { keyName, quantityName, text } from "../text/text.js";
import { line, pageChart } from "./page_chart.js";
import { keysIn } from "./quantities.js";

const labelled = (label, input) => {
  input.id = freshId("sweep");
  return element("div", { className: "field" }, element("label", { for: input.id, textContent: label }),
    input);
};
const number = (value, properties) =>
  element("input", { type: "number", step: "any", value, ...properties });

export class SweepPanel {
  /// `page`: { store, vocabulary, catalogue, pool, inspector, running(), busy(on) }.
  constructor(root, page) {
    Object.assign(this, page, { page });
    this.key = element("select", { onchange: () => this.suggest() });
    this.from = number("");
    this.to = number("");
    this.count = number(5, { min: 2, max: 50, step: 1 });
    this.spacing = element("select", {}, text.spacings.map(([value, name]) =>
      element("option", { value, textContent: name })));
    this.quantity = element("select", { onchange: () => this.draw() });
    this.go = button(text.runSweep, () => this.toggle(), { className: "primary" });
    this.save = button(text.saveSweep, () => this.download(), { className: "quiet", hidden: true });
    this.progress = element("progress", { max: 1, value: 0, hidden: true, "aria-label": text.sweep });
    this.status = element("p", { className: "note", "aria-live": "polite" });
    this.chart = pageChart(text.sweepCurve);
    this.table = element("div", { className: "scroll", tabIndex: 0, role: "region",
      "aria-label": text.sweepCurve });
    this.results = element("div", { hidden: true }, labelled(text.sweepQuantity, this.quantity),
      this.chart.figure, this.table);
    root.append(element("p", { className: "note", textContent: text.sweepAbout }),
      element("div", { className: "fields" }, labelled(text.sweepKey, this.key),
        labelled(text.sweepFrom, this.from), labelled(text.sweepTo, this.to),
        labelled(text.sweepCount, this.count), labelled(text.sweepSpacing, this.spacing)),
      element("div", { className: "row" }, this.go, this.save, this.progress), this.status,
      this.results);
    this.store.addEventListener("text", () => this.follow());
  }

  fields() {
    const where = ["mill", "jar", "balls", "powder", "contact"];
    return this.store.sections.filter(({ name }) => where.includes(name)).flatMap((section) =>
      fieldsOf(this.vocabulary, section, ["mill", "jar"].includes(section.name)
        ? kindOf(this.store.sections, section.name, this.catalogue) : null))
      .filter(({ kind, stated }) => kind === "quantity" && stated);
  }

  follow() {
    const fields = this.fields();
    const plan = fields.map(({ address }) => address).join();
    if (plan !== this.plan) {
      const chosen = this.key.value;
      this.key.replaceChildren(...fields.map(({ address, label }) => element("option",
        { value: address, textContent: `${keyName(address, label)} (${address})` })));
      if (fields.some(({ address }) => address === chosen)) this.key.value = chosen;
    }
    if (plan !== this.plan || !this.touched) this.suggest();
    this.plan = plan;
  }

  /// A range around the present value.
  suggest() {
    const field = this.fields().find(({ address }) => address === this.key.value);
    if (!field) return;
    const { number: at, unit } = field.quantity;
    const range = rangeOf(field, at, unit, millOf(this.store.sections, this.catalogue));
    const within = (value) => Number(Math.min(Math.max(value, range.least), range.most).toPrecision(2));
    const whole = range.whole ? Math.round : (value) => value;
    this.from.value = whole(within(at * 0.5));
    this.to.value = whole(within(at * 1.5 || range.most));
    this.unit = unit;
    this.whole = range.whole;
    for (const [input, name] of [[this.from, text.sweepFrom], [this.to, text.sweepTo]])
      input.previousSibling.textContent = unit ? `${name} [${unit}]` : name;
  }

  async toggle() {
    if (this.sweep?.status === "computing") return this.sweep.stop();
    const [from, to] = [this.from.valueAsNumber, this.to.valueAsNumber];
    const count = Math.min(Math.max(Math.round(this.count.valueAsNumber) || 2, 2), 50);
    const logarithmic = this.spacing.value === "log";
    if (!Number.isFinite(from) || !Number.isFinite(to) || (logarithmic && !(from * to > 0))) {
      this.status.textContent = text.sweepFault;
      return;
    }
    if (this.page.running()) {
      this.status.textContent = text.sweepWaits;
      return;
    }
    this.page.busy(true); // before the check, during which Run may be pressed
    try {
      await this.compute(from, to, count, logarithmic);
    } finally {
      this.page.busy(false);
    }
  }

  async compute(from, to, count, logarithmic) {
    const checked = await this.store.check();
    if (checked.faults.length > 0) {
      this.status.textContent = text.faultsFirst;
      return;
    }
    const numbers = valuesBetween(from, to, count, logarithmic)
      .map((value) => (this.whole ? Math.round(value) : value));
    const points = [...new Set(numbers)].map((each) => ({ number: each, value: join(each, this.unit) }));
    this.sweep = new Sweep(this.pool, this.inspector, { toml: this.store.text, key: this.key.value,
      points, replicates: checked.replicates }, () => this.show());
    this.axis = `${this.key.selectedOptions[0].textContent}${this.unit ? `, ${this.unit}` : ""}`;
    await this.sweep.start();
  }

  show() {
    const { sweep } = this;
    const computing = sweep.status === "computing";
    this.go.textContent = computing ? text.stop : text.runSweep;
    this.progress.hidden = !computing;
    this.progress.value = sweep.share();
    this.status.textContent = text.sweepStatus(sweep.status, Math.min(sweep.at, sweep.points.length),
      sweep.points.length);
    const done = sweep.points.filter(({ summary, fault }) => summary || fault).length;
    if (done === this.drawn && computing) return;
    this.drawn = done;
    this.draw();
  }

  draw() {
    const points = this.sweep?.points.filter(({ summary }) => summary) ?? [];
    this.results.hidden = !this.sweep?.points.some(({ summary, fault }) => summary || fault);
    this.save.hidden = this.chart.figure.hidden = this.quantity.parentElement.hidden = points.length === 0;
    if (points.length === 0) {
      if (!this.results.hidden) this.table.replaceChildren(this.rows(null));
      return;
    }
    const keys = keysIn(points[0].summary);
    if (this.quantity.options.length !== keys.length)
      this.quantity.replaceChildren(...keys.map((key) =>
        element("option", { value: key, textContent: quantityName(key, points[0].summary[key]) })));
    const key = this.quantity.value, label = quantityName(key, points[0].summary[key]);
    const values = points.map(({ summary }) => summary[key] ?? { value: null });
    const largest = Math.max(...values.map(({ value }) => Math.abs(value ?? 0)));
    const { factor, unit } = multipleOf(largest, values[0].unit ?? "1");
    const ends = (sign) => values.map(({ value, ci95 }) => (ci95 > 0 ? (value + sign * ci95) / factor : null));
    this.chart.show({ title: text.sweepCurve, shape: 0.5, x: { label: this.axis, log: this.spacing.value === "log" },
      y: { label: unit ? `${label} (${unit})` : label, log: false },
      series: [line("", points.map((point) => point.number), values.map(({ value }) => (value === null ? null : value / factor)),
        { mark: "points", low: ends(-1), high: ends(1) })] });
    this.table.replaceChildren(this.rows(key, label));
  }

  rows(key, label = text.sweepQuantity) {
    return element("table", {}, element("thead", {}, element("tr", {},
      element("th", { scope: "col", textContent: this.key.value }),
      element("th", { scope: "col", textContent: label }))),
    element("tbody", {}, this.sweep.points.filter(({ summary, fault }) => summary || fault)
      .map((point) => element("tr", {},
        element("th", { scope: "row", textContent: String(point.value) }),
        element("td", { className: "figure",
          textContent: point.fault ?? quantityText(point.summary[key]) })))));
  }

  download() {
    const points = this.sweep.points.filter(({ summary }) => summary);
    const keys = keysIn(points[0].summary);
    const names = keys.flatMap((key) => [key, `${key}_ci95`]);
    download("sweep.csv", writeCsv([this.sweep.key, ...names], points.map(({ value, summary }) =>
      [value, ...keys.flatMap((key) => [summary[key]?.value, summary[key]?.ci95])])), "text/csv");
  }
}
