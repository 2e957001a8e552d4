// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page computes the numbers of the program to the bit.

import { execFile } from "node:child_process";
import { existsSync, mkdirSync, readFileSync, readdirSync, writeFileSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { promisify } from "node:util";
import { write } from "../src/case/toml_text.js";
import { expect, Skip } from "./check.js";
import { dropped, open, openCase, runAgain, saved, tab } from "./steps.js";

const call = promisify(execFile);
const planetary = readFileSync(new URL("../examples/planetary-mill.toml", import.meta.url), "utf8");
const values = { "run.time": "0.2 s", "run.settle": "0.1 s", "run.replicates": 2,
  "run.sensitivity": "off" }; // the page computes no further runs with other assumed values
const short = Object.entries(values).reduce((toml, [key, value]) => write(toml, key, value), planetary);

/// The lines of a summary, without the two that tell how long the computer took and the one with the
/// version of the program. Numbers are written with all their digits.
const linesOf = (summary) => summary.split("\n")
  .filter((line) => !/^\s*"(wall_seconds|cpu_seconds|mahlwerk)":/.test(line));

/// Computes the case on the page and with the program: the summaries must be the same.
async function sameBits({ page, url, folder, native }, toml) {
  if (!native || !existsSync(native)) throw new Skip(`no program is named by --native${native ? `: ${native}` : ""}`);
  mkdirSync(`${folder}/native`);
  writeFileSync(`${folder}/case.toml`, toml);
  await call(native, ["run", `${folder}/case.toml`, "--out", `${folder}/native`, "--quiet"]);
  await openCase(page, url, toml);
  await runAgain(page);
  await tab(page, "files");
  await saved(page, `${folder}/summary.json`, () => page.click('.file:text-is("summary.json")'));
  const [there, here] = [`${folder}/native/summary.json`, `${folder}/summary.json`]
    .map((path) => linesOf(readFileSync(path, "utf8")));
  expect("a result", here.length > 100);
  const differing = here.map((line, i) => [line, there[i]]).filter(([a, b]) => a !== b);
  expect("lines that differ", differing.slice(0, 5), []);
  expect("number of lines", here.length, there.length);
}

async function the_event_engine_has_the_bits_of_the_program(given) {
  await sameBits(given, short);
}

async function the_soft_engine_has_the_bits_of_the_program(given) {
  await sameBits(given, write(short, "run.engine", "soft"));
}

const examples = fileURLToPath(new URL("../../examples/", import.meta.url));
const brief = (name) => [`run.time=${name === "06-powder-as-grains" ? 0.02 : 0.1} s`, "run.settle=0 s",
  "run.replicates=2", "run.sensitivity=off"];

/// The pictures of the page of a result, by their titles: of every run, and the others of an example.
const everyRun = ["Spectrum of impact energies", "Power by impact energy", "Normal and tangential energy of collisions",
  "Impact angle of collisions above the threshold", "Impacts on the wall", "Mass and velocity of the charge",
  "Collisions with a normal speed of at least 0.1 m/s", "Power"];
const otherPictures = {
  "07-wear-and-heat": ["Temperature over milling and pauses"],
  "08-how-fine": ["Grains captured by a collision", "Energy of captured grains per mass",
    "Collisions by number of captured grains", "Sizes over time of milling", "Share of the mass finer than a size",
    "Share of the mass by size", "Specific surface over time of milling"],
  "11-ignition": ["Conversion over time"],
  "12-sensors": ["Temperature over milling and pauses", "Power of the motor", "Hits that the microphone hears",
    "Acceleration of the jar", "Thermocouple"],
  "15-bed-breakage": ["Sizes of the powder in the bed"],
};
const ofCampaign = ["Regime", ...[["collision rate above threshold", "/s"], ["mean normal energy above threshold", "mJ"],
  ["mean contact-point energy above threshold", "mJ"], ["dissipated power", "W"]].flatMap(([quantity, unit]) =>
  [quantity, `${quantity} (${unit})`])];

/// The page of a result has all its pictures and tells all its notices.
async function expectWhole(report, name, { _about: about, _parts: parts = [] }) {
  const all = await report.locator(".chart-head strong").allTextContents();
  const ofParts = parts.map((part) => `Impacts on ${part.name}`); // by power, in an order of their own
  expect(`maps of the parts of ${name}`, all.filter((each) => ofParts.includes(each)).sort(), ofParts.sort());
  const titles = all.filter((each) => !ofParts.includes(each));
  expect(`pictures of ${name}`, titles, about ? [...everyRun, ...otherPictures[name] ?? []] : ofCampaign);
  const said = await report.locator("body").innerText();
  for (const { code, text } of about?.notices ?? []) expect(`${code} of ${name} is told`, said.includes(text));
}

/// The files of the result of an example that runs for a moment.
async function filesOfExample(native, name, out) {
  const command = name === "09-campaign" ? "sweep" : "run";
  await call(native, [command, `${examples}/${name}`, "--out", out, "--quiet",
    ...brief(name).flatMap((each) => ["--set", each])]);
  const names = readdirSync(out).filter((file) => /\.(json|csv|toml|html)$/.test(file));
  return Object.fromEntries(names.map((file) => [file, readFileSync(`${out}/${file}`, "utf8")]));
}

async function results_of_all_examples_are_shown({ page, url, folder, native }) {
  if (!native || !existsSync(native)) throw new Skip("no program is named by --native");
  // Wear over time has a result for each stage, and a page of its own.
  const names = readdirSync(examples).filter((name) => /^\d\d-/.test(name) && name !== "14-liner-wear");
  expect("examples", names.length, 14);
  await open(page, url);
  for (const name of names) {
    const files = await filesOfExample(native, name, `${folder}/${name}`);
    await page.dispatchEvent("body", "drop", { dataTransfer: await dropped(page, files) });
    const opened = () => document.querySelector("#status").textContent.startsWith("Opened: ");
    await page.waitForFunction(opened).catch(async () => {
      throw new Error(`${name}: ${await page.textContent("#status")}`);
    });
    await tab(page, "report");
    const told = JSON.parse(files["summary.json"] ?? files["campaign.json"]), title = told._about?.title ?? told.title;
    const report = page.frameLocator("iframe");
    await report.locator("h1").filter({ hasText: title }).waitFor();
    await expectWhole(report, name, told);
    if (told._about) expect(name, await page.textContent(".result .title"), title);
    await page.evaluate(() => (document.querySelector("#status").textContent = ""));
  }
}

export const nativeTests = [results_of_all_examples_are_shown, the_event_engine_has_the_bits_of_the_program,
  the_soft_engine_has_the_bits_of_the_program];
