// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The form of an estimate: a mill of the catalogue, jar, balls and powder in a few words.

import { element, freshId } from "../dom.js";
import { text } from "../text/text.js";
import { aboutWord, driveOf, fits, jarsOf, millCalled } from "./estimate_words.js";

const first = { mill: "Retsch MM 400", jar: "25 ml", material: "zirconia-ytzp", balls: "2x10mm", drive: "30 Hz",
  powder: "200 mg", time: "1 h" };

const optionOf = ({ value, name }) => element("option", { value, textContent: name });

/// One field with its label, a hint and the fault of its word.
class WordField {
  constructor(word, control) {
    const id = freshId("word");
    this.control = control;
    this.label = element("label", { for: id, textContent: text.estimateWord(word) });
    this.hint = element("p", { id: `${id}-hint`, className: "note", textContent: text.estimateHint(word) });
    this.fault = element("p", { id: `${id}-fault`, className: "word-fault", hidden: true });
    Object.assign(control, { id });
    control.setAttribute("aria-describedby", `${id}-hint ${id}-fault`);
    this.root = element("div", { className: "word" }, this.label, control, this.hint, this.fault);
    this.root.dataset.word = word;
  }

  get value() {
    return this.control.value.trim();
  }

  showFault(told) {
    this.fault.textContent = told;
    this.fault.hidden = told === "";
    this.control.setAttribute("aria-invalid", String(told !== ""));
  }
}

export class EstimateForm {
  /// `known`: vocabulary and catalogue. `estimate(words)` makes and runs the case; it resolves with faults and text.
  constructor(root, known, estimate) {
    Object.assign(this, { known, estimate });
    const line = () => element("input", { type: "text", spellcheck: false, autocomplete: "off", autocapitalize: "off" });
    const { mills, materials } = known.catalogue;
    const names = element("datalist", { id: freshId("mills") }, mills.map(({ title }) => element("option", { value: title })));
    const mill = Object.assign(line(), { oninput: () => this.chooseMill(), onfocus: () => mill.select() });
    mill.setAttribute("list", names.id);
    const solid = materials.filter(({ fixed }) => fixed.has("youngs_modulus"))
      .map(({ name, title }) => ({ value: name, name: title }));
    const controls = { mill, jar: element("select"), material: element("select", {}, solid.map(optionOf)),
      balls: line(), drive: line(), powder: line(), time: line() };
    this.fields = Object.fromEntries(Object.entries(controls).map(([word, control]) =>
      [word, new WordField(word, control)]));
    for (const [word, { control }] of Object.entries(this.fields)) control.value = first[word];
    this.fault = element("p", { className: "word-fault", role: "alert", hidden: true });
    this.form = element("form", { noValidate: true, "aria-label": text.estimateHeading,
      onsubmit: (event) => (event.preventDefault(), this.submit()) },
    Object.values(this.fields).map((field) => field.root), names, this.fault,
    element("div", { className: "sending" },
      element("button", { type: "submit", className: "primary", textContent: text.estimate }),
      element("p", { className: "note", textContent: text.estimateAbout })));
    root.append(element("details", { className: "estimate", open: true },
      element("summary", { textContent: text.estimateHeading }), this.form));
    this.chooseMill();
    this.fields.jar.control.value = first.jar;
  }

  /// Jars and speed are those of the mill, if there is one of this name.
  chooseMill() {
    const mill = millCalled(this.fields.mill.value, this.known);
    if (!mill || mill === this.mill) return;
    this.mill = mill;
    const jars = jarsOf(mill, this.known), { control: jar } = this.fields.jar, before = jar.value;
    jar.replaceChildren(...jars.map(optionOf));
    const middle = jars[0].value === "" ? jars[0] : jars[Math.floor(jars.length / 2)];
    jar.value = (jars.find(({ value }) => value === before) ?? middle).value;
    this.drive = driveOf(mill, this.known);
    const { label, hint, control } = this.fields.drive;
    label.textContent = text.estimateDrive(this.drive.key);
    hint.textContent = text.estimateRange(this.drive);
    if (!fits(control.value, this.drive)) control.value = this.drive.fixed ? "" : this.drive.start;
  }

  /// The words as the command line takes them; the empty ones are left out.
  words() {
    const { balls, drive, ...rest } = Object.fromEntries(Object.entries(this.fields).map(([word, { value }]) => [word, value]));
    const given = { ...rest, [this.drive.key]: drive };
    return { ...Object.fromEntries(Object.entries(given).filter(([, value]) => value !== "")),
      mill: rest.mill, balls: balls.split(/[,;]/).map((each) => each.trim()).filter(Boolean) };
  }

  async submit() {
    if (this.waiting) return;
    this.waiting = true;
    const { faults, text: toml } = await this.estimate(this.words());
    this.waiting = false;
    this.showFaults(faults, toml);
  }

  /// Each fault at the field of its word; the others above the button.
  showFaults(faults, toml) {
    const told = Object.fromEntries(Object.keys(this.fields).map((word) => [word, []])), other = [];
    for (const fault of faults) {
      const { word, kind } = aboutWord(fault, toml);
      (told[word] ?? other).push(text.estimateFault(kind, word, fault));
    }
    for (const [word, field] of Object.entries(this.fields)) field.showFault(told[word].join(" "));
    this.fault.textContent = other.join(" ");
    this.fault.hidden = other.length === 0;
    Object.values(this.fields).find(({ fault }) => !fault.hidden)?.control.focus();
  }
}
