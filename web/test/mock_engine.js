// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// An engine without physics: the contract of src/engine.js with invented numbers, for tests of the page.

import { entryOf, parse, rawOf, write } from "../src/case/toml_text.js";
import { split } from "../src/case/quantity.js";
import catalogue from "./data/catalogue.json";
import { keys as vocabulary, units } from "test-vocabulary";
import { filmOf } from "./mock_film.js";
import { grindingOf, reportOf, sizesOf, spectrumOf, summaryOf, timeseriesOf } from "./mock_tables.js";

const replicateTime = 0.5; // s of computing for one replicate, whatever it simulates

function factor(value, fallback) {
  const quantity = split(value ?? fallback);
  const factors = { ms: 1e-3, us: 1e-6, min: 60, h: 3600, mm: 1e-3, cm: 1e-2, "%": 1e-2 };
  return quantity ? quantity.number * (factors[quantity.unit] ?? 1) : Number.NaN;
}

function applied(toml, set) {
  return set.reduce((text, [key, value]) =>
    write(text, key, Number.isFinite(Number(value)) ? Number(value) : value), toml);
}

const lineOf = (text, position) => text.slice(0, position).split("\n").length;

function faultsOf(text) {
  const faults = [];
  const add = (line, what, remedy, code) =>
    faults.push({ where: line ? `case.toml:${line}` : "case.toml", line, column: line ? 1 : 0,
      text: what, remedy, code });
  const sections = parse(text);
  for (const section of sections) {
    const known = vocabulary.filter((each) => each.section === section.name);
    if (known.length === 0) add(lineOf(text, section.start), `unknown section [${section.name}]`,
      "see docs/cases.md", "unknown-section");
    const keys = new Set(known.flatMap((each) => each.keys.map(({ key }) => key)));
    for (const [key, { line, raw }] of section.keys) {
      if (known.length > 0 && !keys.has(key) && !keys.has("KEY"))
        add(line, `unknown key \`${key}\` in [${section.name}]`, "see docs/cases.md", "unknown-key");
      if (raw === "" || /^"[^"]*$/.test(raw)) add(line, `${key} has no value`, "write a value", "toml");
    }
  }
  for (const name of ["mill", "jar", "balls", "run"])
    if (!sections.some((section) => section.name === name))
      add(0, `there is no [${name}]`, `add the section [${name}]`, "missing-value");
  const time = entryOf(sections, "run.time");
  if (time && !(factor(time.value) > 0))
    add(time.line, `time = ${rawOf(time.value)}: this is not a time above 0`,
      "write for instance time = \"60 s\"", "bad-quantity");
  return faults;
}

function settingsOf(text) {
  const sections = parse(text);
  const value = (address) => entryOf(sections, address)?.value;
  const sets = sections.filter(({ name }) => name === "balls");
  const counts = sets.map(({ keys }) => Number(keys.get("count")?.value ?? 30));
  return {
    title: String(value("title") ?? "case"),
    engine: value("run.engine") ?? "auto",
    replicates: Number(value("run.replicates") ?? 5),
    time: factor(value("run.time")), settle: factor(value("run.settle"), "0 s") || 0, // 0: "auto" too
    counts, radii: sets.map(({ keys }) => factor(keys.get("diameter")?.value, "10 mm") / 2),
    drive: factor(value("mill.frequency") ?? value("mill.speed"), 10),
    planetary: /fritsch|planetary/.test(`${value("mill.model")} ${value("mill.kind")}`),
    restitution: Number(value("contact.restitution") ?? 0.8),
    collapses: value("contact.lasting") === "none",
    powder: sections.some(({ name }) => name === "grinding"),
  };
}

const origins = [
  { key: "gravity", value: "9.81 m/s2", source: "default: on Earth", assumed: true, unverified: false },
  { key: "contact.rolling_friction", value: "0.01", source: "default: uncalibrated, 0-0.1",
    assumed: true, unverified: false },
  { key: "mill.jars_carried", value: "2", source: "maker's data sheet", assumed: false,
    unverified: true },
];
const notices = [{ severity: "warning", code: "invented",
  text: "These numbers are invented: the page runs with the engine of its tests." }];

const collapse = "bounces have collapsed";

class MockEngine {
  version = "0.1.0 (test)";

  vocabulary() {
    return { keys: vocabulary, units, catalogue };
  }

  estimate({ mill, jar, material, balls, frequency, speed }) {
    const wrong = balls.find((set) => !/^\d+x.*mm$/.test(set));
    if (wrong !== undefined) return { text: "", faults: [{ where: `--balls ${wrong}`, line: 0, column: 0,
      text: "this is no number and diameter", remedy: "", code: "bad-command-line" }] };
    const sets = balls.map((set) => `[[balls]]\ncount = ${set.split("x")[0]}\ndiameter = "${set.split("x")[1]}"\n` +
      `material = "${material}"\n`);
    const drive = frequency ? `frequency = "${frequency}"` : `speed = "${speed}"`;
    return { faults: [], text: `title = "${mill}, ${jar}, ${balls}"\n\n[mill]\nmodel = "${mill}"\n${drive}\n\n[jar]\n` +
      `model = "${jar}"\n\n${sets.join("\n")}\n[run]\ntime = "1 s"\n` };
  }

  check(toml, set) {
    const text = applied(toml, set);
    const faults = faultsOf(text);
    const settings = settingsOf(text);
    const { title, engine, replicates, time, settle, counts } = settings;
    return { faults, notices, title, engine, balls: counts.reduce((a, b) => a + b, 0), replicates,
      time, settle, origins, film: faults.length > 0 ? null : filmOf(settings, 1, 0) };
  }

  open(toml, set, replicate) {
    this.settings = settingsOf(applied(toml, set));
    this.replicate = replicate;
    this.spent = 0;
    return this.check(toml, set);
  }

  advance(milliseconds) {
    const until = Date.now() + milliseconds;
    while (Date.now() < until);
    this.spent = Math.min(this.spent + milliseconds / 1000, replicateTime);
    const total = this.settings.time + this.settings.settle;
    const stopped = this.settings.collapses && this.spent > replicateTime / 2;
    return { done: stopped || this.spent >= replicateTime, simulated: this.simulated(), total,
      collisions: Math.round(this.simulated() * 150), stop_reason: stopped ? collapse : "" };
  }

  simulated() {
    return ((this.settings.time + this.settings.settle) * this.spent) / replicateTime;
  }

  summary() {
    return summaryOf(this.settings, this.simulated(), this.replicate, notices);
  }

  table(name) {
    if (name === "spectrum") return spectrumOf(this.settings, this.simulated(), this.replicate);
    if (name === "timeseries") return timeseriesOf(this.settings, this.simulated(), this.replicate);
    return "";
  }

  film() {
    const frames = Math.round((120 * this.spent) / replicateTime);
    return frames < 2 ? null : filmOf(this.settings, frames, this.simulated());
  }

  state() {
    return new TextEncoder().encode(JSON.stringify({ simulated: this.simulated() }));
  }

  finish(toml, set, states) {
    const settings = settingsOf(applied(toml, set));
    const done = states.map((state) => JSON.parse(new TextDecoder().decode(state)).simulated);
    const simulated = done.reduce((a, b) => a + b, 0);
    const endings = settings.collapses ? states.map((_, i) => ({ severity: "warning", code: "stopped",
      text: `Replicate ${i + 1} was stopped: ${collapse}` })) : [];
    this.finished = {
      "summary.json": JSON.stringify(summaryOf(settings, simulated, 0, [...notices, ...endings])),
      "report.html": reportOf(settings),
      "case.resolved.toml": toml,
      "spectrum.csv": spectrumOf(settings, simulated, 0),
      "timeseries.csv": timeseriesOf(settings, simulated, 0),
    };
    if (settings.powder) Object.assign(this.finished, { "size_distribution.csv": sizesOf(settings),
      "grinding.csv": grindingOf(settings) });
    return { faults: [], files: Object.keys(this.finished) };
  }

  file(name) {
    return this.finished[name];
  }
}

export async function load() {
  return new MockEngine();
}
