// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The form: fields for the values of the case. They follow the text, and change it value by value.

import { button, element, freshId } from "../dom.js";
import { keyName, text } from "../text/text.js";
import { fieldsOf, kindOf, millOf } from "./field_list.js";
import { kindsOf, withJar, withKind, withMill } from "./mill_choice.js";
import { QuantityField } from "./quantity_field.js";
import { removeSection } from "./toml_text.js";

const shown = ["mill", "drive", "jar", "parts", "balls", "powder", "flow", "contact", "run"];
const listed = new Set(["parts", "balls"]); // sections of which a case may have several

class SelectField {
  constructor(label, groups, change, { about = "", seen = true } = {}) {
    const id = freshId("field");
    const option = ({ value, name, title }) => element("option", { value, textContent: name, title });
    this.select = element("select", { id, onchange: () => change(this.select.value) },
      groups.map(({ name, options }) => name
        ? element("optgroup", { label: name }, options.map(option)) : options.map(option)).flat());
    this.root = element("div", { className: "field wide", title: about },
      element("label", { for: id, textContent: label, className: seen ? "" : "for-readers" }),
      this.select);
  }

  show({ value, fallback }) {
    const wanted = String(value ?? fallback ?? "");
    if (![...this.select.options].some((option) => option.value === wanted))
      this.select.prepend(element("option", { value: wanted, textContent: wanted || "–" }));
    this.select.value = wanted;
  }
}

export class Form {
  constructor(root, store, { vocabulary, catalogue }) {
    Object.assign(this, { root, store, vocabulary, catalogue });
    this.fields = new Map();
    store.addEventListener("text", () => this.follow());
  }

  sections() {
    const { sections } = this.store;
    return sections.filter(({ name }) => shown.includes(name))
      .map((section) => {
        const kind = ["mill", "jar"].includes(section.name)
          ? kindOf(sections, section.name, this.catalogue) : section.keys.get("kind")?.value ?? null;
        return { section, kind, fields: fieldsOf(this.vocabulary, section, kind) };
      });
  }

  /// Shows the case; elements are made anew only if the fields are others than before.
  follow() {
    const sections = this.sections();
    const plan = sections.flatMap(({ section, fields }) =>
      [section.address, ...fields.map(({ address, kind }) => `${address} ${kind}`)]).join("\n");
    if (plan !== this.plan) this.build(sections);
    this.plan = plan;
    const mill = millOf(this.store.sections, this.catalogue);
    for (const { section, fields } of sections) {
      this.choices[section.name]?.show({ value: this.chosen(section) });
      for (const field of fields) this.fields.get(field.address).show(field, mill);
    }
  }

  chosen(section) {
    const model = section.keys.get("model")?.value;
    return model !== undefined ? `model ${model}` : `kind ${section.keys.get("kind")?.value ?? ""}`;
  }

  build(sections) {
    const focused = document.activeElement?.closest?.(".field")?.dataset.address;
    this.fields.clear();
    this.choices = {};
    const many = sections.filter(({ section }) => section.name === "balls").length > 1;
    this.root.replaceChildren(...sections.map((each) => this.group(each, many)),
      element("div", { className: "adders" }, button(text.addBalls, () => this.addBalls())));
    if (focused) this.root.querySelector(`[data-address="${CSS.escape(focused)}"] :is(input, select)`)
      ?.focus();
  }

  group({ section, fields }, many) {
    const name = this.nameOf(section, many);
    const group = element("fieldset", {}, element("legend", {}, name));
    if (section.name === "mill" || section.name === "jar") {
      this.choices[section.name] = this.catalogueChoice(section.name);
      group.append(this.choices[section.name].root);
    }
    for (const field of fields) {
      const made = this.make(field);
      made.root.dataset.address = field.address;
      this.fields.set(field.address, made);
      group.append(made.root);
    }
    if (listed.has(section.name) && (many || section.name !== "balls"))
      group.append(button(text.remove, () => this.store.setText(
        removeSection(this.store.text, section.address), "form"), { className: "quiet remove",
        "aria-label": `${text.remove}: ${name}` }));
    return group;
  }

  nameOf({ name, address, keys }, many) {
    if (name === "parts") return text.part(keys.get("name")?.value ?? address.split(".").pop());
    return name === "balls" && many ? text.ballSet(address.split(".").pop()) : text.section(name);
  }

  make(field) {
    const change = (value) => this.store.setValue(field.address, value);
    if (field.kind === "quantity") return new QuantityField(field, change);
    const options = field.kind === "material"
      ? this.catalogue.materials.map(({ name, title }) => ({ value: name, name: title }))
      : field.words.map((word, i) => ({ value: word, name: text.word(word), title: field.meanings[i] }));
    return new SelectField(keyName(field.address, field.label), [{ options }], change,
      { about: field.about });
  }

  catalogueChoice(where) {
    const entries = where === "mill" ? this.catalogue.mills : this.catalogue.jars;
    const models = entries.map(({ name, title, unverified }) =>
      ({ value: `model ${name}`, name: unverified ? `${title} *` : title,
        title: unverified ? text.containsUnverified : "" }));
    const kinds = kindsOf(this.vocabulary, where).map(({ kind, about }) =>
      ({ value: `kind ${kind}`, name: text.kind(kind), title: about }));
    return new SelectField(text.model(where), [{ name: text.byItsNumbers, options: kinds },
      { name: text.fromCatalogue, options: models }], (value) => this.choose(where, value),
    { seen: false });
  }

  choose(where, value) {
    const [key, name] = value.split(" ");
    const { text: old } = this.store;
    const changed = key === "kind" ? withKind(old, this.vocabulary, where, name)
      : where === "jar" ? withJar(old, name) : withMill(old, this, name);
    this.store.setText(changed, "form");
  }

  addBalls() {
    const sets = this.store.sections.filter(({ name }) => name === "balls");
    const last = sets[sets.length - 1];
    const at = last ? last.end : this.store.text.trimEnd().length;
    const { text: old } = this.store;
    this.store.setText(`${old.slice(0, at)}\n\n[[balls]]\ncount = 1\ndiameter = "5 mm"\n` +
      `material = "steel-1.4034"${old.slice(at)}`, "form");
  }
}
