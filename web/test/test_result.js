// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of runs and results: pause, stop, plots, comparison, sweep, files.

import { readFileSync } from "node:fs";
import { expect, Skip } from "./check.js";
import { caseText, dropped, ended, limit, open, runAgain, saved, tab, writeCase } from "./steps.js";

/// Sets a case that computes for a while: many replicates and a long time.
const longCase = async (page) => writeCase(page, (await caseText(page))
  .replace("replicates = 5", "replicates = 12").replace('time = "60 s"', 'time = "20000 s"'));

const share = (page) => page.evaluate(() => document.querySelector(".run-bar progress").value);

async function pauses_continues_and_stops({ page, url }) {
  await open(page, url);
  await longCase(page);
  await page.click("#run");
  await page.waitForFunction(() => document.querySelector(".run-bar progress").value > 0.02);
  await page.click("#pause");
  await ended(page, "paused");
  await page.waitForTimeout(300);
  const at = await share(page);
  await page.waitForTimeout(700);
  expect("it stands still", await share(page), at);
  await page.click("#pause");
  await page.waitForFunction((before) => document.querySelector(".run-bar progress").value > before, at);
  await page.click("#stop");
  await ended(page, "stopped");
  expect("not all was simulated", (await share(page)) < 1);
  await page.click("#run");
  await ended(page, "computing");
  await page.click("#stop");
  await ended(page, "stopped");
}

async function live_results_appear_while_computing({ page, url }) {
  await open(page, url);
  await longCase(page);
  await page.click("#run");
  await page.waitForSelector(".panel-quantities .note:not([hidden])", { timeout: limit });
  await page.waitForFunction(() => document.body.dataset.run === "computing" &&
    /\d/.test(document.querySelector('.counter[data-key="power"] .value').textContent));
  expect("a spectrum", await page.locator(".plots canvas").count() > 0);
  await page.click("#stop");
  await ended(page, "stopped");
}

async function quantities_have_intervals_and_groups_unfold({ page, url }) {
  await open(page, url);
  const rows = page.locator(".quantities tbody tr:visible");
  const few = await rows.count();
  expect("an interval", /\d.* ± \d.*W$/.test(await page.locator(".quantities .figure").first().textContent()));
  await page.click(".panel-quantities summary:visible");
  expect("more rows", (await rows.count()) > few);
}

async function a_result_says_why_it_ended_early({ page, url }) {
  await open(page, url);
  const box = page.locator(".result-notices");
  const early = (await caseText(page)).replace(/^restitution = 0.9/m, 'restitution = 0.3\nlasting = "none"')
    .replace("replicates = 5", 'replicates = 2\nsettle = "0 s"');
  await writeCase(page, early);
  await runAgain(page);
  expect("the status", (await page.textContent("#status")).startsWith("Ended early:"));
  expect("the reasons come first", (await box.locator("li").allTextContents()).slice(0, 2).map((said) =>
    /^Warning: Replicate (\d) was stopped: .*bounces have collapsed/.exec(said)?.[1]), ["1", "2"]);
  await box.locator("button").click();
  expect("they are in full below", (await page.locator(".panel-about .notices li").first().textContent())
    .includes("Replicate 1 was stopped"));
  await runAgain(page, () => page.selectOption(".examples select", "planetary-mill"));
  expect("another result has no such notice", await box.getByText("was stopped").count(), 0);
}

/// The notice is there as soon as the first replicate was stopped.
async function an_early_end_is_said_while_computing({ page, url }) {
  await open(page, url);
  await writeCase(page, (await caseText(page)).replace("replicates = 5", "replicates = 200")
    .replace(/^restitution = 0.9/m, 'restitution = 0.3\nlasting = "none"'));
  await page.click("#run");
  await page.waitForSelector('body[data-run="computing"] .result-notices li');
  await page.click("#stop");
  await ended(page, "stopped");
}

async function two_settings_are_compared({ page, url }) {
  await open(page, url);
  await tab(page, "comparison");
  await page.click("text=Keep this result as A");
  await page.fill('.field[data-address="mill.frequency"] input[type="number"]', "16");
  await runAgain(page);
  const power = page.locator(".comparison tbody tr").first();
  expect("the power differs", await power.locator(".verdict").textContent(), "differ");
  const cells = await power.locator("td").allTextContents();
  const [a, b] = cells.map((cell) => Number.parseFloat(cell));
  expect("the change", Math.abs(Number.parseFloat(cells[2]) / (100 * (b / a - 1)) - 1) < 0.05);
  expect("what changed", (await page.textContent(".panel-comparison .note"))
    .includes("mill.frequency from 10 Hz to 16 Hz"));
  await page.click("text=Back to the case of A");
  await page.waitForFunction(() => document.querySelector("#case-text").value.includes('"10 Hz"'));
}

async function a_sweep_and_a_run_exclude_each_other({ page, url }) {
  await open(page, url);
  await longCase(page);
  await page.click("#run");
  await ended(page, "computing");
  await tab(page, "sweep");
  await page.click("text=Run the sweep");
  expect("the sweep waits", (await page.textContent(".panel-sweep .note[aria-live]")).includes("A run is being"));
  await page.click("#stop");
  await ended(page, "stopped");
  await page.evaluate(() => { // both within one check of the case
    document.querySelector("#case-text").value += "\n# changed\n";
    document.querySelector("#case-text").dispatchEvent(new Event("input"));
    document.querySelector("#run").click();
    document.querySelector(".panel-sweep .primary").click();
  });
  await page.click(".panel-sweep .primary >> text=Stop");
  await page.waitForFunction(() => !document.querySelector("#run").disabled);
  await page.click("#run");
  await ended(page, "computing");
  await page.click("#stop");
  await ended(page, "stopped");
}

async function faults_of_a_sweep_are_shown({ page, url, engine }) {
  if (engine === "mock") throw new Skip("the engine of the tests takes every diameter");
  await open(page, url);
  await tab(page, "sweep");
  const fields = page.locator(".panel-sweep .fields");
  await fields.locator("select").first().selectOption("jar.diameter");
  const numbers = fields.locator('input[type="number"]');
  for (const [at, value] of ["1", "3", "2"].entries()) await numbers.nth(at).fill(value);
  await page.click("text=Run the sweep");
  await page.waitForFunction(() => document.querySelectorAll(".panel-sweep .scroll tbody tr").length === 2);
  expect("a reason", (await page.textContent(".panel-sweep .scroll tbody tr")).length > 20);
}

async function a_sweep_gives_a_curve({ page, url, folder }) {
  await open(page, url);
  await writeCase(page, (await caseText(page)).replace("replicates = 5", "replicates = 2")
    .replace('time = "60 s"', 'time = "5 s"'));
  await tab(page, "sweep");
  const fields = page.locator(".panel-sweep .fields");
  await fields.locator("select").first().selectOption("mill.frequency");
  const numbers = fields.locator('input[type="number"]');
  await numbers.nth(0).fill("8");
  await numbers.nth(1).fill("12");
  await numbers.nth(2).fill("3");
  await page.click("text=Run the sweep");
  await page.waitForFunction(() => document.querySelectorAll(".panel-sweep .scroll tbody tr").length === 3, null,
    { timeout: limit });
  expect("the values", await page.locator(".panel-sweep .scroll tbody th").allTextContents(),
    ["8 Hz", "10 Hz", "12 Hz"]);
  await saved(page, `${folder}/sweep.csv`, () => page.click("text=Download sweep.csv"));
  expect("rows of the table", readFileSync(`${folder}/sweep.csv`, "utf8").trim().split("\n").length, 4);
  await page.waitForFunction(() => !document.querySelector("#run").disabled);
}

async function files_can_be_saved({ page, url, folder }) {
  await open(page, url);
  await tab(page, "files");
  const save = async (name) => {
    expect("name", await saved(page, `${folder}/${name}`, () => page.click(`.file:text-is("${name}")`)), name);
    return readFileSync(`${folder}/${name}`, "utf8");
  };
  expect("the case", await save("case.toml"), await caseText(page));
  expect("the summary", JSON.parse(await save("summary.json")).dissipated_power.unit, "W");
  expect("a table", (await save("spectrum.csv")).startsWith("energy_low_J,"));
  expect("the report", (await save("report.html")).startsWith("<!"));
}

async function the_report_opens({ page, url }) {
  await open(page, url);
  await tab(page, "report");
  const report = page.frameLocator("iframe");
  await report.locator("h1").first().waitFor({ timeout: limit });
  expect("the title", (await report.locator("h1").first().textContent()).includes("One ball"));
  expect("its styles apply", await report.locator("html").evaluate(() => document.styleSheets.length > 0));
  expect("it has no origin", await report.locator("html").evaluate(() => origin), "null");
}

async function about_these_numbers({ page, url }) {
  await open(page, url);
  await tab(page, "about");
  const text = await page.textContent(".panel-about");
  for (const part of ["mahlwerk run case.toml", "Assumed values", "gravity", "9.81 m/s2"])
    expect(part, text.includes(part));
}

async function a_result_of_the_program_is_opened({ page, url }) {
  await open(page, url);
  await tab(page, "files");
  const read = async (name) => {
    const [file] = await Promise.all([page.waitForEvent("download"), page.click(`.files button:text-is("${name}")`)]);
    return readFileSync(await file.path(), "utf8");
  };
  const files = {};
  for (const name of ["summary.json", "spectrum.csv", "timeseries.csv", "case.resolved.toml"]) files[name] = await read(name);
  const power = await page.textContent('.counter[data-key="power"] .value');
  await runAgain(page, () => page.selectOption(".examples select", "planetary-mill"));
  await page.dispatchEvent("body", "drop", { dataTransfer: await dropped(page, files) });
  await page.waitForFunction(() => document.querySelector("#status").textContent.startsWith("Opened: "));
  expect("its power", await page.textContent('.counter[data-key="power"] .value'), power);
  expect("its spectrum", await page.locator(".plots canvas").count() > 0);
  expect("its case", (await caseText(page)).includes("vibration"));
  await page.dispatchEvent("body", "drop", { dataTransfer: await dropped(page, { "summary.json": "{}" }) });
  await page.waitForFunction(() => document.querySelector("#status").textContent.includes("cannot be shown"));
  const study = { "optimise.html": "<!doctype html><h1>The best</h1>", "best.toml": "title = 'other'" };
  const before = await caseText(page);
  await page.dispatchEvent("body", "drop", { dataTransfer: await dropped(page, study) });
  expect("the page of a search", await page.frameLocator("iframe").locator("h1").textContent(), "The best");
  expect("the case stays", await caseText(page), before);
  await page.dispatchEvent("body", "drop", { dataTransfer: await dropped(page, { "a.png": "" }) });
  await page.waitForFunction(() => document.querySelector("#status").textContent.includes("neither"));
}

export const resultTests = [pauses_continues_and_stops, live_results_appear_while_computing,
  quantities_have_intervals_and_groups_unfold, a_result_says_why_it_ended_early,
  an_early_end_is_said_while_computing,
  two_settings_are_compared, a_sweep_gives_a_curve, a_sweep_and_a_run_exclude_each_other,
  faults_of_a_sweep_are_shown, files_can_be_saved, a_result_of_the_program_is_opened, the_report_opens,
  about_these_numbers];
