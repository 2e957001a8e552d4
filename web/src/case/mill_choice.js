// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Changes of mill and jar: an entry of the catalogue, or a kind with example numbers.

import { entryOf, parse, remove, write } from "./toml_text.js";

// What the catalogue leaves open for its mills, by kind: a first value.
const first = {
  vibration: { frequency: "20 Hz" },
  planetary: { speed: "400 rpm" },
  tumbling: { speed: "70 %" },
  "arc-shaker": { frequency: "25 Hz", arm: "136 mm", swing: "3.8 deg" },
  "figure-eight": {},
  circular: { speed: "1000 rpm" },
};

const firstOfKind = {
  vibration: { frequency: "10 Hz", amplitude: "25 mm" },
  planetary: { orbit_radius: "70 mm", speed: "400 rpm", ratio: "1:-2" },
  tumbling: { speed: "70 %" },
  "arc-shaker": { frequency: "25 Hz", arm: "136 mm", swing: "3.8 deg" },
  "figure-eight": { frequency: "17.67 Hz", stroke_along: "29.5 mm", stroke_across: "12.5 mm" },
  circular: { radius: "17 mm", speed: "1000 rpm" },
  capsule: { diameter: "20 mm", height: "20 mm" },
  cylinder: { diameter: "40 mm", height: "40 mm" },
  "rounded-cylinder": { diameter: "40 mm", height: "40 mm", fillet: "5 mm" },
  sphere: { diameter: "40 mm" },
  box: { width: "40 mm", depth: "40 mm", height: "40 mm" },
};

/// Kinds that can be chosen without a file.
export const kindsOf = (vocabulary, where) =>
  vocabulary.filter(({ section, kind }) => section === where && kind in firstOfKind)
    .map(({ kind, about }) => ({ kind, about }));

/// The text without the keys of a section that belong to a mill or jar.
function emptied(text, where) {
  const section = parse(text).find(({ name }) => name === where);
  const kept = new Set(["jars_carried", "material"]);
  for (const key of section?.keys.keys() ?? [])
    if (!kept.has(key) && !["kind", "model"].includes(key)) text = remove(text, `${where}.${key}`);
  return text;
}

/// Replaces `kind` or `model`, whichever is there, by the other at the same place.
function named(text, where, key, name) {
  const other = key === "kind" ? "model" : "kind";
  const old = entryOf(parse(text), `${where}.${other}`);
  if (!old || entryOf(parse(text), `${where}.${key}`)) text = write(remove(text, `${where}.${other}`),
    `${where}.${key}`, name);
  else {
    const start = text.lastIndexOf("\n", old.from) + 1;
    const end = text.indexOf("\n", old.to);
    text = `${text.slice(0, start)}${key} = ${JSON.stringify(name)}${text.slice(end < 0 ? text.length : end)}`;
  }
  return text;
}

function filled(text, where, values) {
  for (const [key, value] of Object.entries(values)) text = write(text, `${where}.${key}`, value);
  return text;
}

const carriesJar = (text, catalogue, jars) => {
  const model = entryOf(parse(text), "jar.model")?.value;
  return !jars?.length || (model && jars.includes(model));
};

/// The text with a mill of the catalogue, and with one of its jars if the present one does not fit.
export function withMill(text, catalogue, name) {
  const mill = catalogue.mills.find((each) => each.name === name);
  const open = Object.entries(first[mill.kind] ?? {}).filter(([key]) => !mill.fixed.has(key));
  text = filled(named(emptied(text, "mill"), "mill", "model", name), "mill", Object.fromEntries(open));
  return carriesJar(text, catalogue, mill.jars) ? text
    : withJar(text, mill.jars[Math.floor(mill.jars.length / 2)]);
}

export const withJar = (text, name) => named(emptied(text, "jar"), "jar", "model", name);

/// The text with a mill or jar of a kind, with example numbers.
export const withKind = (text, where, kind) =>
  filled(named(emptied(text, where), where, "kind", kind), where, firstOfKind[kind]);

