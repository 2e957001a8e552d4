// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The words of the page in the reader's language: that of the address (?lang=de), else the one that was chosen on the
// page, else the first of the browser's that is here, else English. Numbers have a decimal point in every language: they
// can be copied into a case.

import { text as de } from "./de.js";
import { text as en } from "./en.js";
import { text as zh } from "./zh.js";

export const languages = { en, de, zh };
const key = "mahlwerk-language";

function stored() {
  try {
    return localStorage.getItem(key);
  } catch {
    return null; // pages from disk may have no storage
  }
}

/// The first of `wanted` ("de-AT" means "de") that is a language of the page.
export const languageOf = (wanted) =>
  wanted.map((each) => String(each ?? "").toLowerCase().split(/[-_]/)[0]).find((each) => Object.hasOwn(languages, each)) ?? "en";

const { location: place, navigator: browser } = globalThis; // tests in Node have none
const asked = new URLSearchParams(place?.search).get("lang");

export const text = languages[languageOf([asked, stored(), ...(browser?.languages ?? [])])];

/// Loads the page again in another language. The address names it only if the browser keeps nothing.
export function chooseLanguage(name) {
  const address = new URL(location.href);
  address.searchParams.delete("lang");
  try {
    localStorage.setItem(key, name);
  } catch {
    address.searchParams.set("lang", name);
  }
  history.replaceState(history.state, "", address);
  location.reload();
}

const capital = (words) => words.charAt(0).toUpperCase() + words.slice(1);

/// "Power dissipated": the name of a quantity of a summary. `label`: the program's.
export const quantityName = (name, { label }) => text.quantityNames[name] ?? capital(label);

/// The name of a group of quantities.
export const groupName = (heading) => text.groupNames[heading] ?? heading;

/// The name of a key of the case, "mill.speed" or "speed". `label`: the program's.
export const keyName = (address, label) => text.keyNames[address.split(".").pop()] ?? capital(label);
