// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the modules that need no browser: TOML text, quantities, numbers.

import { readFileSync } from "node:fs";
import { withJar, withKind, withMill } from "../src/case/mill_choice.js";
import { knownOf } from "../src/case/known.js";
import { convert, split, unitsFor, useUnits } from "../src/case/quantity.js";
import { differences, parse, read, remove, removeSection, write } from "../src/case/toml_text.js";
import { History, limits } from "../src/history/history.js";
import { mergedSpectrum } from "../src/run/merge.js";
import { valuesBetween } from "../src/run/sweep_values.js";
import { quantityText } from "../src/format.js";
import { verdictOf } from "../src/results/verdict.js";
import { expect } from "./check.js";
import { vocabulary } from "./vocabulary.js";

const file = (path) => readFileSync(new URL(path, import.meta.url), "utf8");

const sample = `title = "a # b"
[mill]
kind = "vibration"
frequency = "10 Hz"    # comment
list = [1, # one
  2]
last = true
[[balls]]
count = 1
[[balls]]
count = 2 # two`;

function testText() {
  expect("a value with a number sign", read(sample, "title"), "a # b");
  expect("a value with a comment", read(sample, "mill.frequency"), "10 Hz");
  expect("a key after a list", read(sample, "mill.last"), true);
  expect("a second section", read(sample, "balls.2.count"), 2);
  expect("the line of a key", parse(sample)[1].keys.get("last").line, 7);
  const changed = write(sample, "mill.frequency", "100 Hz");
  expect("the comment keeps its column", changed.split("\n")[3], 'frequency = "100 Hz"   # comment');
  expect("only this line changes", write(changed, "mill.frequency", "10 Hz"), sample);
  expect("a new key", read(write(sample, "balls.1.diameter", "5 mm"), "balls.1.diameter"), "5 mm");
  expect("a new section", read(write(sample, "run.time", "1 s"), "run.time"), "1 s");
  expect("a new key at the top of an empty case", write("", "seed", 2).trim(), "seed = 2");
  expect("a removed key", read(remove(sample, "mill.kind"), "mill.kind"), undefined);
  expect("a removed section", read(removeSection(sample, "balls.1"), "balls.1.count"), 2);
  expect("differences", differences(sample, write(sample, "balls.2.count", 3)), [["balls.2.count", 2, 3]]);
  expect("a value with quotes", read(write(sample, "title", 'x"\\y'), "title"), 'x"\\y');
}

function testChoice() {
  const known = knownOf({ ...vocabulary(), catalogue: JSON.parse(file("data/catalogue.json")) });
  const vial = file("../examples/vibrating-vial.toml");
  const mill = withMill(vial, known, "fritsch-p7-classic");
  expect("the mill of the catalogue", [read(mill, "mill.model"), read(mill, "mill.speed"),
    read(mill, "mill.kind"), read(mill, "mill.frequency")], ["fritsch-p7-classic", "300 rpm", null, null]
    .map((value) => value ?? undefined));
  expect("a jar that the mill carries", read(mill, "jar.model"), "fritsch-45ml-steel");
  expect("a jar of a kind", read(withKind(mill, known.vocabulary, "jar", "sphere"), "jar.diameter"), "40 mm");
  expect("a jar of the catalogue", read(withJar(vial, "spex-vial-62ml"), "jar.diameter"), undefined);
}

function testNumbers() {
  useUnits(vocabulary().units);
  expect("a quantity", split("1e-3 kg/m3"), { number: 1e-3, unit: "kg/m3" });
  expect("rpm to Hz", convert(600, "rpm", "Hz"), 10);
  expect("minutes to seconds", convert(1.5, "min", "s"), 90);
  expect("a length in inches", convert(2, "in", "mm"), 50.8);
  expect("degrees Celsius to kelvin", convert(20, "degC", "K"), 293.15);
  expect("units of a length", unitsFor("mm"), ["m", "cm", "mm", "um"]);
  expect("an inch, too, where a case has one", unitsFor("in").includes("in"), true);
  expect("a sieve is no measure", split("200 mesh"), null);
  expect("no conversion", convert(1, "rpm", "%"), null);
  expect("values of a sweep", valuesBetween(1, 100, 3, true), [1, 10, 100]);
  for (const { text, ...told } of JSON.parse(file("../../tests/unit/report/numbers.json")))
    expect(`the program's text of ${told.value} ${told.unit}`, quantityText({ ...told,
      least: told.least ?? undefined, most: told.most ?? undefined }).replaceAll("\u00a0", " "), text);
  expect("intervals apart", verdictOf({ value: 1, ci95: 0.1 }, { value: 2, ci95: 0.1 }), "apart");
  expect("intervals that overlap", verdictOf({ value: 1, ci95: 0.6 }, { value: 2, ci95: 0.6 }), "overlap");
  expect("no interval", verdictOf({ value: 1, ci95: null }, { value: 2, ci95: 0.6 }), "unknown");
  const names = ["low", "high", "rate"];
  expect("merged spectra", mergedSpectrum([{ names, rows: [[1, 2, 4]] },
    { names, rows: [[1, 2, 2], [2, 4, 2]] }]).rows, [[1, 2, 3], [2, 4, 1]]);
}

/// A result of `bytes`, and a browser that keeps all, or nothing.
const filesOf = (bytes) => ({ "summary.json": "{}", "spectrum.csv": "a\n1\n", "report.html": " ".repeat(bytes) });
const keepsAll = { entries: async () => [], put: async () => {}, remove: async () => {}, files: async () => null };
const keepsNone = { ...keepsAll, put: async () => { throw new DOMException("denied", "SecurityError"); } };

async function testHistory() {
  const history = new History(keepsAll);
  const ids = [];
  for (let i = 0; i <= limits.results; ++i) ids.push(history.add("a", `[mill]\nspeed = ${i}`, filesOf(5e6)));
  expect("the oldest result is forgotten", [history.entries.length, history.of(ids[0])], [limits.results, null]);
  expect("what changed", history.of(ids[5]).change, [["mill.speed", 5]]);
  expect("files within the limit", [...history.files.keys()].length, Math.floor(limits.sessionBytes / (5e6 + 8)));
  expect("an old result keeps its numbers", Object.keys(await history.filesOf(ids[1])), ["summary.json", "spectrum.csv"]);
  await history.save(ids[1], "kept");
  for (let i = 0; i < 5; ++i) history.add("b", "", filesOf(1));
  expect("what is saved stays", history.of(ids[1]).name, "kept");
  const denied = new History(keepsNone);
  const id = denied.add("a", "", null);
  expect("why it is not saved", await denied.save(id, "b").catch(({ reason }) => reason), "denied");
  expect("the name holds", denied.of(id).name, "b");
}

export async function textTests() {
  await testHistory();
  testText();
  testChoice();
  testNumbers();
  console.log("fine: texts, choices and numbers");
}
