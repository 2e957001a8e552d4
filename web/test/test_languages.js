// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the languages of the page: each has the words of English, of the same shape.

import { languageOf, languages } from "../src/text/text.js";
import { expect } from "./check.js";
import { vocabulary } from "./vocabulary.js";

const tables = ["quantityNames", "groupNames", "keyNames"]; // empty in English, whose words are the program's

/// The shape of words: texts, functions with their number of arguments, lists and objects of these.
function shapeOf(words) {
  if (typeof words === "function") return `function of ${words.length}`;
  if (Array.isArray(words)) return words.map(shapeOf);
  if (words === null || typeof words !== "object") return words === "" ? "empty" : typeof words;
  return Object.fromEntries(Object.keys(words).sort().map((key) => [key, shapeOf(words[key])]));
}

/// Where two shapes differ.
function unlike(a, b, at = "text") {
  if (JSON.stringify(a) === JSON.stringify(b)) return [];
  if (typeof a !== "object" || typeof b !== "object") return [`${at}: ${JSON.stringify(a)} or ${JSON.stringify(b)}`];
  return [...new Set([...Object.keys(a), ...Object.keys(b)])].flatMap((key) => unlike(a[key], b[key], `${at}.${key}`));
}

const withoutTables = (words) => ({ ...words, englishParts: "", ...Object.fromEntries(tables.map((key) => [key, 0])) });

export function languageTests() {
  const { en, ...others } = languages;
  for (const [name, words] of Object.entries(others)) {
    expect(`the code of ${name}`, words.language, name);
    expect(`words of ${name} that English has not, or of another kind`,
      unlike(shapeOf(withoutTables(en)), shapeOf(withoutTables(words))), []);
    for (const key of tables)
      expect(`${key} of ${name}`, Object.keys(words[key]).sort(), Object.keys(others.de[key]).sort());
    expect(`${name} says what remains English`, words.englishParts !== "");
  }
  const keys = new Set(vocabulary().keys.flatMap((section) => section.keys.map(({ key }) => key)));
  expect("names of keys that no case has", Object.keys(others.de.keyNames).filter((key) => !keys.has(key)), []);
  expect("the language of Austria", languageOf([null, "de-AT", "en"]), "de");
  expect("a language that the page has not", languageOf(["fr"]), "en");
  console.log("fine: languages");
}
