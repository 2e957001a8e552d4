// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A field for a quantity: number, unit and slider. It keeps its elements while values change.

import { element, freshId } from "../dom.js";
import { convert, join, unitsFor } from "./quantity.js";
import { numberAt, placeOf, rangeOf, sliderSteps } from "./ranges.js";
import { keyName, text } from "../text/text.js";

export class QuantityField {
  /// `change(value)`: called with the new value of the case, a number or a text with a unit.
  constructor(field, change) {
    this.change = change;
    const id = freshId("field");
    const label = keyName(field.address, field.label);
    const hint = field.about ? `${id}-about` : null;
    this.number = element("input", { id, type: "number", step: "any", inputMode: "decimal",
      required: true, "aria-describedby": hint, oninput: () => this.typed() });
    this.unit = element("select", { "aria-label": text.unitOf(label),
      onchange: () => this.convert() });
    this.slider = element("input", { type: "range", min: 0, max: sliderSteps, step: 1,
      "aria-label": text.sliderOf(label), oninput: () => this.slid() });
    this.root = element("div", { className: "field", title: field.about },
      element("label", { for: id, textContent: label }),
      element("div", { className: "number" }, this.number, this.unit), this.slider,
      hint && element("span", { id: hint, className: "for-readers", textContent: field.about }));
    this.root.dataset.address = field.address;
  }

  /// Shows the field's value, except where the reader is typing.
  show(field, mill) {
    this.number.setAttribute("aria-invalid", "false");
    this.field = field;
    this.mill = mill;
    const { number, unit } = field.quantity;
    this.current = { number, unit };
    this.optional ||= field.automatic;
    this.number.required = !this.optional;
    this.number.placeholder = this.optional ? text.automatic : "";
    this.root.classList.toggle("unstated", !field.stated);
    const units = unitsFor(unit);
    if ([...this.unit.options].map((option) => option.value).join() !== units.join())
      this.unit.replaceChildren(...units.map((name) =>
        element("option", { value: name, textContent: name || "–" })));
    this.unit.value = unit;
    this.unit.hidden = units.length < 2 || (unit === "" && !/filling|share/.test(field.key));
    if (document.activeElement !== this.number || Number(this.number.value) !== number)
      this.number.value = field.stated || field.fallback !== null ? number : "";
    if (document.activeElement !== this.slider) this.fitSlider();
  }

  fitSlider() {
    const { number, unit } = this.current;
    this.range = rangeOf(this.field, number, unit, this.mill);
    this.slider.value = placeOf(this.range, number);
    this.say();
  }

  say() {
    const { number, unit } = this.current;
    this.slider.setAttribute("aria-valuetext",
      this.field.automatic ? text.automatic : `${number} ${unit}`.trim());
  }

  set(number, unit = this.current.unit) {
    this.current = { number, unit };
    this.change(join(number, unit));
    this.say();
  }

  typed() {
    const { value, validity, valueAsNumber: number } = this.number;
    if (this.optional && value === "" && !validity.badInput) return this.change("auto");
    this.number.setAttribute("aria-invalid", String(!Number.isFinite(number)));
    if (!Number.isFinite(number)) return;
    this.set(number);
    this.fitSlider();
  }

  slid() {
    const number = numberAt(this.range, Number(this.slider.value));
    this.number.value = number;
    this.set(number);
  }

  convert() {
    const unit = this.unit.value;
    if (this.field.automatic) {
      this.current = { number: this.current.number, unit };
      return this.fitSlider();
    }
    const number = convert(this.current.number, this.current.unit, unit) ?? this.current.number;
    this.number.value = number;
    this.set(number, unit);
    this.fitSlider();
  }
}
