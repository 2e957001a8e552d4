// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Changes of mill and jar: an entry of the catalogue, or a kind with first values.

import { keysOf } from "./field_list.js";
import { convert, split } from "./quantity.js";
import { entryOf, parse, remove, write } from "./toml_text.js";

/// The keys that a kind needs; `start` is a first value.
function neededKeys(vocabulary, where, kind) {
  return keysOf(vocabulary, where, kind)
    .filter(({ key, required }) => required && !["kind", "model"].includes(key));
}

/// First values for the keys that a kind needs, except those that are `given`.
const startOf = (vocabulary, where, kind, given = new Set()) =>
  Object.fromEntries(neededKeys(vocabulary, where, kind)
    .filter(({ key, start }) => start !== null && !given.has(key))
    .map(({ key, start }) => [key, split(start)?.unit === "" ? Number(start) : start]));

/// Kinds that can be chosen without a file.
export const kindsOf = (vocabulary, where) =>
  vocabulary.filter(({ section, kind }) => section === where && kind)
    .filter(({ kind }) => neededKeys(vocabulary, where, kind).every(({ start }) => start !== null))
    .map(({ kind, about }) => ({ kind, about }));

/// The value, or the nearest that the mill offers.
function offeredBy(mill, value) {
  const [start, least, most] = [value, mill.least, mill.most].map((each) => split(each ?? ""));
  const inUnit = (end) => end && convert(end.number, end.unit, start.unit);
  if (inUnit(most) !== null && start.number > inUnit(most)) return mill.most;
  return inUnit(least) !== null && start.number < inUnit(least) ? mill.least : value;
}

/// What drives a mill of the catalogue: the key, "frequency" or "speed", and a first value that it offers.
export function firstDrive(mill, { vocabulary }) {
  const { key, start } = keysOf(vocabulary, "mill", mill.kind).find((each) => ["frequency", "speed"].includes(each.key));
  return { key, start: offeredBy(mill, start) };
}

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
export function withMill(text, { vocabulary, catalogue }, name) {
  const mill = catalogue.mills.find((each) => each.name === name);
  const open = Object.entries(startOf(vocabulary, "mill", mill.kind, mill.fixed)).map(([key, value]) =>
    [key, ["frequency", "speed"].includes(key) ? offeredBy(mill, value) : value]);
  text = filled(named(emptied(text, "mill"), "mill", "model", name), "mill", Object.fromEntries(open));
  return carriesJar(text, catalogue, mill.jars) ? text
    : withJar(text, mill.jars[Math.floor(mill.jars.length / 2)]);
}

export const withJar = (text, name) => named(emptied(text, "jar"), "jar", "model", name);

/// The text with a mill or jar of a kind, with first values.
export const withKind = (text, vocabulary, where, kind) =>
  filled(named(emptied(text, where), where, "kind", kind), where, startOf(vocabulary, where, kind));
