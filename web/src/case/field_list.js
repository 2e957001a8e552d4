// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The fields of the form: which keys of the case it shows, from the text and the vocabulary.

import { entryOf } from "./toml_text.js";
import { split } from "./quantity.js";

// Keys that the form shows even if the case leaves them out; they are written when they change.
const offered = {
  mill: ["frequency", "speed", "amplitude", "ratio"],
  jar: [],
  balls: ["count", "diameter"],
  contact: ["restitution"],
  run: ["time", "settle", "replicates"],
};

const hidden = new Set(["kind", "model"]);
const order = ["model", "kind", "frequency", "speed", "amplitude", "count", "filling", "diameter",
  "restitution", "friction", "time", "settle", "replicates", "engine"];

const rank = (key) => (order.includes(key) ? order.indexOf(key) : order.length);

/// Descriptions of the keys of a section in the vocabulary; those of its kind first.
export function keysOf(vocabulary, section, kind) {
  const own = vocabulary.filter((each) => each.section === section && each.kind === kind && kind);
  const common = vocabulary.filter((each) => each.section === section && !each.kind);
  return [...own, ...common].flatMap(({ keys }) => keys);
}

/// Kind of mill or jar: stated, or that of the entry of the catalogue.
export function kindOf(sections, where, catalogue) {
  const model = entryOf(sections, `${where}.model`)?.value;
  const entries = where === "mill" ? catalogue.mills : catalogue.jars;
  return entryOf(sections, `${where}.kind`)?.value ??
    entries.find(({ name }) => name === model)?.kind ?? null;
}

/// The mill of the catalogue that the case names; undefined if it names none.
export function millOf(sections, catalogue) {
  const model = entryOf(sections, "mill.model")?.value;
  return catalogue.mills.find(({ name }) => name === model);
}

/// A quantity that the program determines, by the word "auto" or because the case leaves it out. Its
/// unit is that of the example.
function automatic(base, { example }) {
  const { unit } = split(example);
  return { ...base, fallback: null, kind: "quantity", quantity: { number: 0, unit }, stated: false,
    automatic: true };
}

function fieldOf(known, section, entry, key) {
  const address = section.address ? `${section.address}.${key}` : key;
  const value = entry?.value ?? null;
  const number = ["number", "integer"].includes(known?.type);
  const base = { address, key, label: known?.label ?? key.replaceAll("_", " "), about: known?.about ?? "",
    value, fallback: known?.default ?? null, usual: known?.usual ?? null,
    whole: known?.type === "integer" };
  if (number && known.default_source?.startsWith('"auto"') && [null, "auto"].includes(value))
    return automatic(base, known);
  const quantity = split(value ?? known?.default ?? known?.example);
  const offered = known?.words?.filter((word) => !["lammps", "gpu"].includes(word)); // no browser has them
  const words = offered?.length > 0 ? offered : null;
  if (words && known.type === "word") return { ...base, kind: "word", words,
    meanings: known.meanings ?? [] };
  if (number && quantity && (value === null || split(value)))
    return { ...base, kind: "quantity", quantity, stated: value !== null };
  if (key === "material" && typeof value === "string") return { ...base, kind: "material" };
  return null;
}

/// Fields of one section: `{ address, key, label, about, kind, value, usual, quantity, words }`.
export function fieldsOf(vocabulary, section, kind = null) {
  const known = keysOf(vocabulary, section.name, kind);
  const wanted = new Set([...section.keys.keys()]);
  for (const key of offered[section.name] ?? []) {
    const instead = known.find((each) => each.key === key);
    const replaced = instead && [...(instead.alternatives ?? []), "model"]
      .some((other) => section.keys.has(other.split(".").pop()));
    if (instead && !replaced && (instead.required || section.name !== "mill" || kind)) wanted.add(key);
  }
  if (section.name === "contact" && !section.keys.has("tangential_restitution")) wanted.add("friction");
  return [...wanted].filter((key) => !hidden.has(key))
    .map((key) => fieldOf(known.find((each) => each.key === key), section, section.keys.get(key), key))
    .filter(Boolean)
    .sort((a, b) => rank(a.key) - rank(b.key));
}
