// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the form of an estimate.

import { spawn } from "node:child_process";
import { existsSync, readFileSync } from "node:fs";
import { expect, Skip } from "./check.js";
import { caseText, open, runAgain, tab } from "./steps.js";

const control = (word) => `.word[data-word="${word}"] :is(input, select)`;
const fault = (page, word) => page.textContent(`.word[data-word="${word}"] .word-fault`);
const hint = (page, word) => page.textContent(`.word[data-word="${word}"] .note`);
const estimate = (page) => page.click(".estimate button");

async function an_estimate_makes_and_runs_its_case({ page, url }) {
  await open(page, url);
  await page.fill(control("balls"), "3x8mm");
  await runAgain(page, () => estimate(page));
  const made = await caseText(page);
  expect("the case", made.includes("count = 3\n") && made.includes('diameter = "8mm"'));
  expect("whose case it is", await page.inputValue(".examples select"), "");
  await tab(page, "quantities");
  expect("numbers", await page.locator(".panel-quantities tbody tr").count() > 3);
  await tab(page, "about");
  expect("assumed values", await page.locator(".panel-about .origins tr").count() > 1);
  page.removeAllListeners("dialog");
  page.on("dialog", () => expect("an estimate is left without a question", false));
  await runAgain(page, () => page.selectOption(".examples select", "vibrating-vial"));
}

/// The case that the program saves for the words of its command line, before it computes the bands.
async function savedCase(native, words, file) {
  const program = spawn(native, ["estimate", ...words, "--save", file, "--quiet"], { stdio: "inherit" });
  const ended = new Promise((resolve) => program.on("close", resolve));
  while (program.exitCode === null && !existsSync(file)) await new Promise((resolve) => setTimeout(resolve, 50));
  program.kill("SIGKILL");
  await ended;
  return readFileSync(file, "utf8");
}

/// The case of the form is that of the program for the same words.
async function sameCase({ page, folder, native }, name, words) {
  await runAgain(page, () => estimate(page));
  expect(`the text for the ${name}`, await caseText(page), await savedCase(native, words, `${folder}/${name}.toml`));
}

async function an_estimate_has_the_case_of_the_program(given) {
  const { page, url, engine, native } = given;
  if (engine === "mock") throw new Skip("the engine of the tests makes cases of its own");
  if (!native || !existsSync(native)) throw new Skip("no program is named by --native");
  await open(page, url);
  await sameCase(given, "mixer mill", ["retsch-mm400", "--jar", "25 ml", "--material", "zirconia-ytzp", "--balls", "2x10mm",
    "--frequency", "30 Hz", "--time", "1 h", "--powder", "200 mg"]);
  await page.fill(control("mill"), "PM 100");
  await page.selectOption(control("jar"), "50 ml");
  await page.fill(control("balls"), "4 x 10 mm, 3x8mm");
  await page.fill(control("powder"), "");
  await page.fill(control("time"), "");
  await sameCase(given, "planetary mill", ["PM 100", "--jar", "50 ml", "--material", "zirconia-ytzp", "--balls", "4 x 10 mm",
    "--balls", "3x8mm", "--speed", "300 rpm"]);
}

async function a_mill_has_its_jars_and_its_range({ page, url, engine }) {
  if (engine === "mock") throw new Skip("the catalogue of the tests is old");
  await open(page, url);
  const jars = () => page.locator(`${control("jar")} option`).allTextContents();
  expect("jars of a mixer mill", await jars(), ["1.5 ml", "5 ml", "10 ml", "25 ml", "35 ml", "50 ml"]);
  expect("its range", await hint(page, "drive"), "3 Hz to 30 Hz");
  await page.fill(control("mill"), "fritsch-p7-classic");
  expect("what drives a planetary mill", await page.textContent('.word[data-word="drive"] label'), "Speed");
  expect("a first value", (await page.inputValue(control("drive"))).endsWith("rpm"));
  await page.fill(control("mill"), "Emax");
  expect("the jar of a mill without jars", await page.inputValue(control("jar")), "");
  await estimate(page);
  await page.waitForSelector('.word[data-word="jar"] .word-fault:not([hidden])');
  expect("is asked for", await fault(page, "jar"), "Fill in this field.");
  await page.fill(control("mill"), "spex");
  expect("the only frequency of a mill", await page.inputValue(control("drive")), "");
  expect("which it is", (await hint(page, "drive")).includes("17.67 Hz"));
  await runAgain(page, () => estimate(page));
  expect("is that of the catalogue", (await caseText(page)).includes("frequency"), false);
}

async function a_wrong_word_shows_its_remedy({ page, url, engine }) {
  await open(page, url);
  const before = await caseText(page);
  const refused = async (word, value) => {
    await page.fill(control(word), value);
    await estimate(page);
    await page.waitForSelector(`.word[data-word="${word}"] .word-fault:not([hidden])`);
    expect(`${word} is marked`, await page.getAttribute(control(word), "aria-invalid"), "true");
    expect(`the caret is in ${word}`, await page.locator(control(word)).evaluate((each) => each === document.activeElement));
    return fault(page, word);
  };
  expect("balls", (await refused("balls", "two")).includes("number and diameter, 2x10mm"));
  expect("the case stays", await caseText(page), before);
  if (engine !== "mock") {
    await page.fill(control("balls"), "2x10mm");
    expect("a mill", (await refused("mill", "MM 4000")).includes("Choose one of the list."));
    await page.fill(control("mill"), "MM 400");
    expect("no frequency", await refused("drive", ""), "Fill in this field.");
    expect("a wrong unit", (await refused("drive", "30 rp")).includes("did you mean \"rpm\""));
    await page.fill(control("drive"), "30 Hz");
    expect("a milling time alone", (await page.fill(control("powder"), ""), await refused("time", "1 h"))
      .includes("Fill in the powder"));
    expect("no option of the command line", (await page.textContent(".estimate")).includes("--"), false);
  }
  for (const [word, value] of [["balls", "2x10mm"], ["powder", "200 mg"]]) await page.fill(control(word), value);
  await runAgain(page, () => estimate(page));
  expect("no fault is left", await page.locator(".word-fault:not([hidden])").count(), 0);
}

async function an_estimate_asks_before_it_replaces_changes({ page, url }) {
  await open(page, url);
  await page.fill('.field[data-address="mill.amplitude"] input[type="number"]', "20");
  page.removeAllListeners("dialog");
  const asked = page.waitForEvent("dialog").then((dialog) => dialog.dismiss());
  await estimate(page);
  await asked;
  expect("a refusal keeps the case", (await caseText(page)).includes('amplitude = "20 mm"'));
  page.once("dialog", (each) => each.accept());
  await runAgain(page, () => estimate(page));
  await page.goBack();
  await page.waitForFunction(() => document.querySelector("#case-text").value.includes('"20 mm"'));
}

async function an_estimate_needs_no_mouse({ page, url }) {
  await open(page, url);
  await page.locator(".estimate summary").focus();
  const reached = [];
  for (let i = 0; i < 8; ++i) {
    await page.keyboard.press("Tab");
    reached.push(await page.evaluate(() => document.activeElement.closest(".word")?.dataset.word ??
      document.activeElement.textContent));
  }
  expect("the order of the fields", reached,
    ["mill", "jar", "material", "balls", "drive", "powder", "time", "Estimate"]);
  await page.locator(control("balls")).focus();
  await page.keyboard.press("Control+A");
  await page.keyboard.type("4x9mm");
  await runAgain(page, () => page.keyboard.press("Enter"));
  expect("the case", (await caseText(page)).includes("count = 4"));
}

export const estimateTests = [an_estimate_makes_and_runs_its_case, an_estimate_has_the_case_of_the_program,
  a_mill_has_its_jars_and_its_range, a_wrong_word_shows_its_remedy, an_estimate_asks_before_it_replaces_changes,
  an_estimate_needs_no_mouse];
