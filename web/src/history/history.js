// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The results of this session, and cases and results that were saved by name.

import { parseCsv } from "../csv.js";
import { differences } from "../case/toml_text.js";
import { Storage } from "./storage.js";

export const limits = { results: 20, saved: 100, // entries
  sessionBytes: 60e6, savedBytes: 100e6 }; // of files

const bytesOf = (files) => Object.values(files ?? {}).reduce((sum, text) => sum + text.length, 0);
const withoutReport = ({ "report.html": _, ...rest }) => rest;

/// Why an entry cannot be saved; `reason`: "full" or "denied".
class NotSaved extends Error {
  constructor(reason) {
    super(reason);
    this.reason = reason;
  }
}

/// Dispatches "change". An entry: { id, name, title of the case, date [ms], saved, toml, summary and spectrum (texts of files, null
/// without a result), bytes, change: what differs from the result before it }.
export class History extends EventTarget {
  constructor(storage = new Storage()) {
    super();
    this.storage = storage;
    this.entries = []; // the newest first
    this.files = new Map(); // id -> files of results of this session, as a blob: the browser keeps it outside the page
    this.available = true;
  }

  /// Reads what was saved before. Without storage the history holds this session alone.
  async load() {
    try {
      const kept = await this.storage.entries();
      this.entries.push(...kept.map((entry) => ({ ...entry, saved: true })).sort((a, b) => b.date - a.date));
    } catch {
      this.available = false;
    }
    this.changed();
  }

  changed() {
    this.dispatchEvent(new Event("change"));
  }

  of(id) {
    return this.entries.find((entry) => entry.id === id) ?? null;
  }

  /// Adds a result (`files`: name -> text) or a case (files null). Returns its id.
  add(name, toml, files) {
    const before = this.entries.find((entry) => entry.summary && entry.title === name);
    const entry = { id: crypto.randomUUID?.() ?? `${Date.now()}-${Math.random()}`, name, title: name, date: Date.now(),
      saved: false, toml, summary: files?.["summary.json"] ?? null, spectrum: files?.["spectrum.csv"] ?? null, bytes: bytesOf(files),
      change: before && files ? differences(before.toml, toml).slice(0, 4).map(([key, , to]) => [key, to ?? null]) : [] };
    this.entries.unshift(entry);
    if (files) this.files.set(entry.id, new Blob([JSON.stringify(files)]));
    this.trim();
    this.changed();
    return entry.id;
  }

  /// Forgets the oldest results of the session beyond the limits: first their files, then the results.
  trim() {
    const session = this.entries.filter(({ saved }) => !saved);
    for (const { id } of session.slice(limits.results)) this.forget(id);
    let sum = 0;
    for (const { id, bytes } of session) {
      if (!this.files.has(id)) continue;
      sum += bytes;
      if (sum > limits.sessionBytes) this.files.delete(id);
    }
  }

  forget(id) {
    this.entries = this.entries.filter((entry) => entry.id !== id);
    this.files.delete(id);
  }

  /// Keeps an entry in the browser, by a name, also by another one. Throws NotSaved. The report is left out where there is
  /// no room for it.
  async save(id, name) {
    const entry = this.of(id);
    const saved = this.entries.filter((each) => each.saved && each.id !== id);
    if (saved.length >= limits.saved) throw new NotSaved("full");
    const room = limits.savedBytes - saved.reduce((sum, { bytes }) => sum + bytes, 0);
    let files = entry.saved ? undefined : await this.sessionFiles(id);
    if (files && bytesOf(files) > room) files = withoutReport(files);
    if (bytesOf(files) > room) throw new NotSaved("full");
    const made = { ...entry, name, saved: true, bytes: entry.saved ? entry.bytes : bytesOf(files) };
    try {
      await this.storage.put(made, files);
    } catch (error) {
      entry.name = name; // until the page is closed
      this.changed();
      throw new NotSaved(error?.name === "QuotaExceededError" ? "full" : "denied");
    }
    Object.assign(entry, made);
    this.changed();
  }

  async remove(id) {
    const { saved } = this.of(id);
    this.forget(id);
    this.changed();
    if (saved) await this.storage.remove(id).catch(() => {});
  }

  /// The files of a result of this session; undefined if they are forgotten.
  async sessionFiles(id) {
    const kept = this.files.get(id);
    return kept && JSON.parse(await kept.text());
  }

  /// The files of a result: all, or those with its numbers; null for a case.
  async filesOf(id) {
    const entry = this.of(id);
    if (!entry.summary) return null;
    const kept = await this.sessionFiles(id) ?? (entry.saved ? await this.storage.files(id).catch(() => null) : null);
    return kept ?? { "summary.json": entry.summary, ...entry.spectrum ? { "spectrum.csv": entry.spectrum } : {} };
  }

  /// { id, title, toml, summary, spectrum } of an entry with a result, as the comparison takes it.
  resultOf(id) {
    const entry = this.of(id);
    if (!entry?.summary) return null;
    return { id, title: entry.name, toml: entry.toml, summary: JSON.parse(entry.summary),
      spectrum: entry.spectrum ? parseCsv(entry.spectrum) : null };
  }
}
