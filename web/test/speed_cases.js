// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Cases computed by turns with the program and in a worker of the page. One clock, that of this
// process, measures both: from the start of the program to its end, and from Run to the merged result.

import { execFileSync } from "node:child_process";
import { mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { write } from "../src/case/toml_text.js";
import { withoutWebGL } from "./check.js";
import { median } from "./median.js";
import { openCase, runAgain, saved, tab } from "./steps.js";

function caseOf(example, changes) {
  const text = readFileSync(new URL(`../examples/${example}.toml`, import.meta.url), "utf8");
  return Object.entries({ "run.replicates": 1, ...changes })
    .reduce((toml, [key, value]) => write(toml, key, value), text);
}

const cases = {
  "event engine, one ball in a vial": caseOf("vibrating-vial", { "run.time": "4000 s" }),
  "event engine, seven balls, planetary mill": caseOf("planetary-mill", { "run.time": "24 s" }),
  "soft engine, seven balls, planetary mill": caseOf("planetary-mill",
    { "run.engine": "soft", "run.time": "1.5 s" }),
  "event engine, 459 balls in a drum": caseOf("tumbling-drum",
    { "balls.1.diameter": "12 mm", "run.time": "0.2 s" }),
  "soft engine, 459 balls in a drum": caseOf("tumbling-drum",
    { "balls.1.diameter": "12 mm", "run.engine": "soft", "run.settle": "0 s", "run.time": "0.1 s" }),
};

const secondsOf = async (act) => {
  const begun = performance.now();
  await act();
  return (performance.now() - begun) / 1000;
};

/// The page with a case: `run` computes it, `figures` reads the result.
async function pageWith(context, url, toml, folder) {
  const page = await context.newPage();
  await openCase(page, url, toml);
  await tab(page, "files");
  const figures = async () => {
    await saved(page, join(folder, "page.json"), () => page.click('.file:text-is("summary.json")'));
    const collisions = await page.textContent('.counter[data-key="collisions"] .value');
    return { collisions: Number(collisions.replace(/\D/g, "")),
      engine: JSON.parse(readFileSync(join(folder, "page.json"), "utf8"))._about.cpu_seconds };
  };
  return { page, run: () => runAgain(page), figures };
}

function programWith(native, toml, folder) {
  const [path, out] = [join(folder, "case.toml"), join(folder, "native")];
  mkdirSync(out, { recursive: true });
  writeFileSync(path, toml);
  return { run: () => execFileSync(native, ["run", path, "--out", out, "--force", "--threads", "1", "--quiet"]),
    figures: () => ({ engine: JSON.parse(readFileSync(join(out, "summary.json"), "utf8"))._about.cpu_seconds }) };
}

async function measure(context, url, native, toml, turns) {
  const folder = mkdtempSync(join(tmpdir(), "mahlwerk-speed-"));
  const there = programWith(native, toml, folder);
  const here = await pageWith(context, url, toml, folder);
  await here.run(); // starts the worker and compiles the module
  const turn = [];
  let collisions = 0;
  for (let i = 0; i < turns; ++i) {
    const program = await secondsOf(there.run);
    const page = await secondsOf(here.run);
    const figures = await here.figures();
    collisions = figures.collisions;
    turn.push({ program, page, engines: [there.figures().engine, figures.engine] });
  }
  await here.page.close();
  rmSync(folder, { recursive: true });
  return { collisions, turn };
}

/// Prints collisions per second of both and their ratio; medians over the turns.
export async function caseFigures(browser, url, native, turns) {
  const context = await browser.newContext({ reducedMotion: "reduce", acceptDownloads: true });
  await context.addInitScript(withoutWebGL);
  context.setDefaultTimeout(120e3);
  for (const [name, toml] of Object.entries(cases)) {
    const { collisions, turn } = await measure(context, url, native, toml, turns);
    const rate = (seconds) => Math.round(collisions / seconds).toLocaleString("en").replaceAll(",", " ");
    const ratios = turn.map(({ program, page }) => program / page);
    const engines = median(turn.map(({ engines: [a, b] }) => a / b));
    console.log(`${name}: ${rate(median(turn.map(({ program }) => program)))} collisions/s native, ` +
      `${rate(median(turn.map(({ page }) => page)))} on the page, ratio ${median(ratios).toFixed(2)} ` +
      `(${Math.min(...ratios).toFixed(2)} to ${Math.max(...ratios).toFixed(2)}); the engines alone ` +
      `${engines.toFixed(2)}; native ${median(turn.map(({ program }) => program)).toFixed(2)} s`);
  }
  await context.close();
}
