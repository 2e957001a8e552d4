// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What an estimate may ask of a mill of the catalogue, and which of its words a fault is about.

import { firstDrive } from "./mill_choice.js";
import { convert, split } from "./quantity.js";
import { parse } from "./toml_text.js";

const plain = (word) => word.toLowerCase().replaceAll(/[^\p{L}\p{N}]/gu, "");

/// The mill that a word means: by its name, its title or another of its names; undefined: none, or several.
export function millCalled(word, { catalogue }) {
  const wanted = plain(word);
  const found = catalogue.mills.filter(({ name, title, names }) =>
    [name, title, ...names].some((each) => plain(each) === wanted));
  return catalogue.mills.find(({ name }) => name === word) ?? (found.length === 1 ? found[0] : undefined);
}

/// The jars of a mill, or none and all others if the catalogue names none of it: `{ value, name }`. The value is the
/// volume where only one jar of the mill has it.
export function jarsOf(mill, { catalogue }) {
  const own = catalogue.jars.filter(({ name }) => mill.jars.includes(name));
  if (own.length === 0)
    return [{ value: "", name: "–" }, ...catalogue.jars.map(({ name, title }) => ({ value: name, name: title }))];
  const millilitres = ({ volume }) => (volume ? convert(split(volume).number, split(volume).unit, "ml") : null);
  const volumes = own.map(millilitres);
  const alone = (volume) => volume !== null && volumes.filter((each) => each === volume).length === 1;
  return own.map((jar, i) => ({ order: volumes[i] ?? Infinity,
    ...alone(volumes[i]) ? { value: jar.volume, name: jar.volume } : { value: jar.name, name: jar.title } }))
    .sort((a, b) => a.order - b.order).map(({ value, name }) => ({ value, name }));
}

/// What drives a mill: `{ key, start, least, most, fixed }`. `key` is "frequency" or "speed"; `start` a first value;
/// `fixed` the value of the mill, if it has only one; the others may be missing.
export const driveOf = (mill, known) => ({ ...firstDrive(mill, known), least: mill.least, most: mill.most,
  fixed: mill.fixedDrive });

/// Whether a value lies in the range of the mill.
export function fits(value, { least, most, fixed }) {
  const given = split(value);
  const inUnit = (end) => (end ? convert(split(end).number, split(end).unit, given.unit) : null);
  if (!given || fixed || inUnit(most) === null) return false;
  return given.number <= inUnit(most) && given.number >= (inUnit(least) ?? 0);
}

const wordOfKey = { "mill.model": "mill", "mill.frequency": "drive", "mill.speed": "drive", "mill.amplitude": "",
  "jar.model": "jar", "jar.kind": "jar", "jar.material": "material", "balls.material": "material",
  "balls.density": "material", "milling.time": "time" };
const wordOfSection = { jar: "jar", balls: "balls", powder: "powder" };
const wordOfOption = { MILL: "mill", "--jar": "jar", "--balls": "balls", "--powder": "powder", "--time": "time" };

const wordOf = (section, key) => wordOfKey[`${section}.${key}`] ?? wordOfSection[section] ?? "";

/// The word of the form that a fault is about, "" if none, and the kind of the fault: "written" for a word that makes no
/// case, "missing", "value" for one that the case refuses. `toml`: the case whose lines the faults cite.
export function aboutWord(fault, toml) {
  const option = wordOfOption[fault.where.split(" ")[0]];
  if (option !== undefined) return { word: option, kind: "written" };
  const lacking = fault.code === "missing-value" && fault.text.match(/^\[+(\w+)\]+ lacks `(\w+)`/);
  const lacked = lacking ? wordOf(lacking[1], lacking[2]) : "";
  if (lacked !== "") return { word: lacked, kind: "missing" };
  for (const section of parse(toml))
    for (const [key, { line }] of section.keys)
      if (line === fault.line) return { word: wordOf(section.name, key), kind: "value" };
  return { word: "", kind: "value" };
}
