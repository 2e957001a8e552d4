// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A result that the program computed, from the files of its folder.

import { parseCsv } from "../csv.js";

const studies = ["campaign", "fit", "optimise", "match", "compare", "paper"].map((name) => `${name}.html`);
const wanted = new RegExp(`(?:^summary\\.json|^report\\.html|^(?:${studies.join("|")})|\\.csv|\\.toml)$`);
const largest = 1 << 26; // bytes of a file that is read

/// Files of a drop or of a choice, also those in a folder: name -> text.
export async function filesOf(items) {
  const found = await Promise.all([...items].map((item) => {
    const entry = item.webkitGetAsEntry?.();
    return entry?.isDirectory ? inFolder(entry) : item.getAsFile?.() ?? item;
  }));
  const chosen = found.flat().filter((file) => file?.name && wanted.test(file.name) && file.size < largest);
  return Object.fromEntries(await Promise.all(chosen.map(async (file) => [file.name, await file.text()])));
}

async function inFolder(entry) {
  const reader = entry.createReader(), files = [];
  for (;;) { // a hundred entries at a time
    const some = await new Promise((resolve, reject) => reader.readEntries(resolve, reject));
    if (some.length === 0) break;
    files.push(...some.filter(({ isFile }) => isFile));
  }
  return Promise.all(files.map((file) => new Promise((resolve, reject) => file.file(resolve, reject))));
}

/// The text of the case among files; null without one.
export const caseAmong = (files) => files["case.resolved.toml"] ?? files["case.toml"] ??
  files[Object.keys(files).find((name) => name.endsWith(".toml"))] ?? null;

/// The page of a campaign, a search or a comparison among files; null without one.
export const studyAmong = (files) => files[studies.find((name) => name in files)] ?? null;

/// The film of the replay in a report, or null. Its JSON holds no "<" (json_string of the program).
export function filmOf(report = "") {
  const found = report.match(/<script type="application\/json" id="replay-data">([^<]*)<\/script>/);
  return found && JSON.parse(found[1]);
}

export class OpenedRun {
  /// Throws if `summary.json` is no summary of Mahlwerk. `checked`: the check of its case.
  constructor(files, toml, checked) {
    this.summary = JSON.parse(files["summary.json"]);
    const { _about: about, _groups: groups, _key_quantities: keys } = this.summary;
    if (!about || !Array.isArray(groups) || !Array.isArray(keys)) throw new Error("no summary of a result");
    const origins = [...(about.assumed ?? []).map((each) => ({ ...each, assumed: true })),
      ...(about.unverified ?? []).map((each) => ({ ...each, unverified: true }))];
    Object.assign(this, { files, toml, status: "done", seconds: about.wall_seconds ?? 0,
      replicates: about.replicates ?? [], checked: { title: about.title, origins, ...checked } });
  }

  /// Everything is computed.
  share() {
    return 1;
  }

  /// Of "simulated" [s] and "collisions", which are those counted.
  sum(key) {
    const counted = this.replicates.reduce((all, { time }) => all + (time ?? 0), 0);
    const settling = this.replicates.reduce((all, each) => all + (each.settling ?? 0), 0);
    return key === "simulated" ? counted + settling : Math.round(counted * (this.summary.collision_rate?.value ?? 0));
  }

  endedEarly() {
    return this.summary._about.complete === false;
  }

  quantities() {
    return this.summary;
  }

  table(name) {
    const text = this.files[`${name}.csv`];
    return text ? parseCsv(text) : null;
  }

  spectrum() {
    return this.table("spectrum");
  }
}
