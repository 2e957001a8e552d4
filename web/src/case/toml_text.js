// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Values of a case as positions in its text, so that one value can change while comments stay. The
// engine parses and checks the case; this module only has to find keys and values.
//
// An address is "title", "mill.frequency", "balls.2.count" or "contact.pairs.1.friction": the numbers
// count the sections of the same name from 1.

/// End of the value that starts at `at`: a comment or the end of the line, outside of texts and lists.
function endOfValue(text, at) {
  let depth = 0;
  for (let i = at; i < text.length; ++i) {
    const c = text[i];
    if (c === '"' || c === "'") {
      const long = text.startsWith(c.repeat(3), i) ? c.repeat(3) : c;
      i = endOfText(text, i + long.length, long);
    } else if (c === "[" || c === "{") ++depth;
    else if (c === "]" || c === "}") --depth;
    else if (c === "#" && depth === 0) return i;
    else if (c === "#") i = lineEnd(text, i) - 1;
    else if (c === "\n" && depth <= 0) return i;
  }
  return text.length;
}

function lineEnd(text, at) {
  const end = text.indexOf("\n", at);
  return end < 0 ? text.length : end;
}

/// Position of the last character of the quotes that close a text.
function endOfText(text, at, quotes) {
  for (let i = at; i < text.length; ++i) {
    if (text[i] === "\\" && quotes[0] === '"') ++i;
    else if (text.startsWith(quotes, i)) return i + quotes.length - 1;
    else if (text[i] === "\n" && quotes.length === 1) return i - 1;
  }
  return text.length;
}

function valueOf(raw) {
  if (raw === "true" || raw === "false") return raw === "true";
  if (/^'[^']*'$/.test(raw)) return raw.slice(1, -1);
  if (/^".*"$/s.test(raw) && !raw.startsWith('"""')) {
    try {
      return JSON.parse(raw);
    } catch {
      return raw.slice(1, -1);
    }
  }
  const number = Number(raw.replaceAll("_", ""));
  return raw !== "" && Number.isFinite(number) ? number : raw;
}

const header = /^[ \t]*(\[\[?)[ \t]*([^\]\n]+?)[ \t]*\]\]?[ \t]*(?:#.*)?$/;
const assignment = /^[ \t]*([A-Za-z0-9_."'-]+(?:[ \t]*\.[ \t]*[A-Za-z0-9_."'-]+)*)[ \t]*=[ \t]*/;

/// Sections in order: `name`, `address` ("balls.2"), `start`, `end` (position after its last key)
/// and `keys`: a Map from the key to `{ raw, value, from, to, line }`.
export function parse(text) {
  const sections = [{ name: "", address: "", start: 0, end: 0, keys: new Map() }];
  const counts = {};
  for (let at = 0, line = 1; at < text.length;) {
    const stop = lineEnd(text, at);
    const row = text.slice(at, stop);
    const section = sections[sections.length - 1];
    const opened = row.match(header);
    const given = opened ? null : row.match(assignment);
    let next = stop + 1;
    if (opened) {
      const [, bracket, name] = opened;
      const number = bracket === "[[" ? (counts[name] = (counts[name] ?? 0) + 1) : 0;
      sections.push({ name, address: number ? `${name}.${number}` : name, start: at, end: stop,
        keys: new Map() });
    } else if (given) {
      const from = at + given[0].length;
      const rest = endOfValue(text, from);
      const raw = text.slice(from, rest).trimEnd();
      section.keys.set(given[1].replaceAll(/["' \t]/g, ""),
        { raw, value: valueOf(raw), from, to: from + raw.length, line });
      section.end = lineEnd(text, rest);
      next = section.end + 1;
    }
    line += text.slice(at, next).split("\n").length - 1;
    at = next;
  }
  return sections;
}

/// Section and key of an address: the key is its last part.
export function split(address) {
  const dot = address.lastIndexOf(".");
  return dot < 0 ? ["", address] : [address.slice(0, dot), address.slice(dot + 1)];
}

export function entryOf(sections, address) {
  const [where, key] = split(address);
  return sections.find((section) => section.address === where)?.keys.get(key);
}

export const read = (text, address) => entryOf(parse(text), address)?.value;

/// The raw TOML of a value: texts get quotes, numbers and flags none.
export const rawOf = (value) => (typeof value === "string" ? JSON.stringify(value) : String(value));

/// The text with a new value at the address. A comment on the line keeps its column if it can.
export function write(text, address, value) {
  const raw = rawOf(value);
  const sections = parse(text);
  const entry = entryOf(sections, address);
  if (!entry) return insert(text, sections, address, raw);
  let rest = text.slice(entry.to);
  const gap = rest.match(/^([ \t]+)#/);
  if (gap) {
    const wide = Math.max(1, gap[1].length + entry.raw.length - raw.length);
    rest = " ".repeat(wide) + rest.slice(gap[1].length);
  }
  return text.slice(0, entry.from) + raw + rest;
}

function insert(text, sections, address, raw) {
  const [where, key] = split(address);
  const section = sections.find((each) => each.address === where);
  if (!section) {
    const name = where.replace(/\.\d+$/, "");
    const head = name === where ? `[${name}]` : `[[${name}]]`;
    return `${text.trimEnd()}\n\n${head}\n${key} = ${raw}\n`.trimStart();
  }
  const line = `${key} = ${raw}`;
  if (section.address === "" && section.keys.size === 0) return `${line}\n${text}`;
  return `${text.slice(0, section.end)}\n${line}${text.slice(section.end)}`;
}

/// The text without the line of the key at the address.
export function remove(text, address) {
  const entry = entryOf(parse(text), address);
  if (!entry) return text;
  const start = text.lastIndexOf("\n", entry.from) + 1;
  return text.slice(0, start) + text.slice(lineEnd(text, entry.to) + 1);
}

/// The text without the section at the address, up to the next one.
export function removeSection(text, address) {
  const sections = parse(text);
  const at = sections.findIndex((section) => section.address === address);
  if (at < 1) return text;
  return text.slice(0, sections[at].start) + text.slice(sections[at + 1]?.start ?? text.length);
}

/// Keys whose values differ: list of [address, value of one, value of other]; undefined: not given.
export function differences(one, other) {
  const flat = (text) => new Map(parse(text).flatMap(({ address, keys }) =>
    [...keys].map(([key, { value }]) => [address ? `${address}.${key}` : key, value])));
  const [a, b] = [flat(one), flat(other)];
  return [...new Set([...a.keys(), ...b.keys()])].filter((key) => a.get(key) !== b.get(key))
    .map((key) => [key, a.get(key), b.get(key)]);
}
