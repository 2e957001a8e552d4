// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the case: form, text, faults, examples, links.

import { drawn, expect, Skip } from "./check.js";
import { caseText, ended, limit, open, openCase, runAgain, tab, writeCase } from "./steps.js";

const frequency = '.field[data-address="mill.frequency"]';

async function runs_the_first_example_at_once({ page, url, note }) {
  const begun = Date.now();
  await page.goto(url);
  await page.waitForFunction(() => ["computing", "merging", "done"].includes(document.body.dataset.run));
  note(`computing after ${Date.now() - begun} ms`);
  await ended(page);
  note(`first result after ${Date.now() - begun} ms`);
  expect("collisions", Number((await page.textContent('.counter[data-key="collisions"] .value'))
    .replace(/\D/g, "")) > 0);
  await page.waitForSelector('#replay[data-state="drawn"]');
}

async function without_webgl_the_numbers_are_shown({ page, url }) {
  await open(page, url);
  await page.waitForSelector('#replay[data-state="no-webgl"]');
  expect("why", (await page.textContent("#replay .sorry")).includes("WebGL 2"));
  expect("plots", await page.locator(".plots canvas").count() > 0);
}

async function a_changed_value_reaches_the_text_and_keeps_comments({ page, url }) {
  await open(page, url);
  await page.fill('.field[data-address="mill.amplitude"] input[type="number"]', "20");
  expect("text", (await caseText(page)).includes('amplitude = "20 mm"              # half the stroke'));
  await page.locator(`${frequency} input[type="range"]`).focus();
  await page.keyboard.press("End");
  expect("the end of the slider", (await caseText(page)).includes('frequency = "60 Hz"'));
  expect("the number beside it", await page.inputValue(`${frequency} input[type="number"]`), "60");
  await page.waitForSelector(".stale:not([hidden])");
  await page.selectOption(`${frequency} .number select`, "rpm");
  expect("another unit", (await caseText(page)).includes('frequency = "3600 rpm"'));
}

async function settling_is_automatic_without_a_time({ page, url }) {
  await open(page, url);
  const number = page.locator('.field[data-address="run.settle"] input[type="number"]');
  const shown = async () => [await number.inputValue(), await number.getAttribute("placeholder")];
  expect("a case without the key", await shown(), ["", "auto"]);
  expect("the text of such a case", (await caseText(page)).includes("settle"), false);
  await number.fill("0.5");
  expect("a time", (await caseText(page)).includes('settle = "0.5 s"'));
  await number.fill("");
  expect("no time", (await caseText(page)).includes('settle = "auto"'));
  expect("the word in the form", await shown(), ["", "auto"]);
  expect("no fault", await number.evaluate((input) => input.checkValidity()));
}

async function a_changed_text_reaches_the_form({ page, url }) {
  await open(page, url);
  const text = (await caseText(page)).replace('"10 Hz"', '"12.5 Hz"');
  await writeCase(page, text);
  await tab(page, "form");
  expect("the number", await page.inputValue(`${frequency} input[type="number"]`), "12.5");
}

async function faults_are_shown_at_their_line({ page, url }) {
  await open(page, url);
  const text = await caseText(page);
  await writeCase(page, text.replace("[jar]\n", "[jar]\nshape = 3\n"));
  const line = text.split("\n").indexOf("[jar]") + 2;
  await page.waitForSelector(".faults li");
  expect("the place", await page.textContent(".faults .place"), `Line ${line}`);
  expect("the fault", (await page.textContent(".faults li")).includes("shape"));
  expect("a remedy", (await page.textContent(".faults .remedy")).startsWith("Remedy:"));
  expect("the line is marked", (await page.textContent(".editor .faulty")).trim(), "shape = 3");
  expect("run is not possible", await page.isDisabled("#run"));
  await page.click(".faults .place");
  expect("the caret is there", await page.evaluate(() => {
    const area = document.activeElement;
    return area.value.slice(area.selectionStart, area.selectionEnd);
  }), "shape = 3");
  await writeCase(page, text);
  expect("mended", await page.locator(".faults li").count(), 0);
  expect("run is possible", await page.isDisabled("#run"), false);
}

async function broken_text_does_no_harm({ page, url }) {
  await open(page, url);
  for (const text of ["", "[", "a = \"", "[mill]\nfrequency =", "\u0000", "x".repeat(50000)]) {
    await writeCase(page, text);
    await page.waitForSelector(".faults li");
  }
}

async function a_title_with_markup_does_no_harm({ page, url }) {
  await open(page, url);
  const title = "</script><script>window.harm = 1</script><img src=x onerror='window.harm = 1'>";
  await writeCase(page, (await caseText(page)).replace(/^title = .*/, `title = ${JSON.stringify(title)}`));
  await runAgain(page);
  expect("the title is text", await page.textContent(".result .title"), title);
  await tab(page, "report");
  const report = page.frameLocator("iframe");
  await report.locator("h1").first().waitFor({ timeout: limit });
  await page.waitForTimeout(500);
  expect("nothing ran", await page.evaluate(() => window.harm ?? 0), 0);
  const frame = page.frames().find((each) => each.url().includes("report_frame"));
  expect("nothing ran in the report", await frame.evaluate(() => window.harm ?? 0), 0);
}

async function a_changed_case_survives_a_reload({ page, url }) {
  await open(page, url);
  await page.fill('.field[data-address="mill.amplitude"] input[type="number"]', "20");
  await page.waitForTimeout(500);
  await page.reload();
  await page.waitForSelector('body[data-case="fine"]', { timeout: limit });
  expect("the text", (await caseText(page)).includes('amplitude = "20 mm"'));
  expect("its example", await page.inputValue(".examples select"), "vibrating-vial");
  expect("nothing runs", await page.evaluate(() => document.body.dataset.runs ?? "none"), "none");
  expect("what is said", (await page.textContent(".run-bar")).includes("Your case as you left it"));
}

async function back_brings_a_left_case_back({ page, url }) {
  await open(page, url);
  await page.fill('.field[data-address="mill.amplitude"] input[type="number"]', "20");
  page.removeAllListeners("dialog");
  page.once("dialog", (dialog) => dialog.dismiss());
  await page.selectOption(".examples select", "mixer-mill");
  expect("a refusal keeps the case", (await caseText(page)).includes('amplitude = "20 mm"'));
  expect("and the example", await page.inputValue(".examples select"), "vibrating-vial");
  page.once("dialog", (dialog) => dialog.accept());
  await runAgain(page, () => page.selectOption(".examples select", "mixer-mill"));
  await page.goBack();
  await page.waitForFunction(() => document.querySelector("#case-text").value.includes('"20 mm"'), { timeout: limit });
  expect("the example before", await page.inputValue(".examples select"), "vibrating-vial");
  await page.goForward();
  await page.waitForFunction(() => document.querySelector("#case-text").value.includes("retsch-mm400"), { timeout: limit });
}

async function parts_motor_and_flow_have_fields({ page, url, engine }) {
  if (engine === "mock") throw new Skip("the engine of the tests draws no parts");
  await open(page, url);
  await writeCase(page, `[mill]
kind = "tumbling"
speed = "60 rpm"

[drive]
inertia = "1e-3 kg m2"
torque = "0.05 N m"

[jar]
kind = "cylinder"
diameter = "100 mm"
height = "60 mm"

[[parts]]
name = "bar"
kind = "blade"
length = "8 mm"
height = "50 mm"
thickness = "4 mm"
position = ["44 mm", "0 mm", "0 mm"]

[[balls]]
count = 20
diameter = "6 mm"
density = "7800 kg/m3"

[contact]
restitution = 0.5
friction = 0.4
softening = 1e-3

[run]
engine = "soft"
time = "0.2 s"
settle = "0.1 s"
replicates = 1
`);
  await tab(page, "form");
  const number = (key) => page.locator(`.field[data-address="${key}"] input[type="number"]`);
  expect("the torque of the motor", await number("drive.torque").inputValue(), "0.05");
  expect("the length of the blade", await number("parts.1.length").inputValue(), "8");
  await number("parts.1.length").fill("9");
  expect("the text", (await caseText(page)).includes('length = "9 mm"'));
  expect("no fault", (await page.textContent("#case-faults")).trim(), "");
  await page.click('button[aria-label="Remove: Part: bar"]');
  expect("a removed part", (await caseText(page)).includes("[[parts]]"), false);
}

async function engines_that_a_browser_has_not_are_not_offered({ page, url }) {
  await open(page, url);
  const offered = await page.locator('.field[data-address="run.engine"] option').evaluateAll((all) =>
    all.map((option) => option.value));
  expect("the soft engine", offered.includes("soft"));
  expect("LAMMPS", offered.includes("lammps"), false);
}

const examplesOf = (page) => page.locator(".examples option").evaluateAll((all) =>
  all.map((option) => option.value).filter(Boolean));

async function every_example_is_a_case({ page, url }) {
  await open(page, url);
  const names = await examplesOf(page);
  expect("number of examples", names.length, 6);
  for (const name of [...names.slice(1), names[0]]) {
    await runAgain(page, () => page.selectOption(".examples select", name));
    expect(`${name} has no fault`, await page.locator(".fault-line:not([hidden])").count(), 0);
    expect(`${name} says what to try`, (await page.textContent(".hint")).includes("ry "));
  }
}

async function every_example_is_drawn({ page, url }) {
  await open(page, url);
  for (const name of [...(await examplesOf(page)).slice(1), "vibrating-vial"]) {
    await page.selectOption(".examples select", name);
    await page.waitForSelector('body[data-case="fine"]');
    await page.waitForFunction(() => document.querySelector("#replay .scene")
      ?.getAttribute("aria-label").includes(document.querySelector(".result .title").textContent));
    expect(`${name} is drawn without fault`, await page.getAttribute("#replay", "data-error"), null);
  }
}

async function mills_and_jars_can_be_chosen({ page, url }) {
  await open(page, url);
  const [mill, jar] = [page.locator("fieldset select").first(), "model fritsch-45ml-steel"];
  await mill.selectOption("model fritsch-p7-classic");
  expect("the text", /model = "fritsch-p7-classic"[^]*speed = "300 rpm"/.test(await caseText(page)));
  expect("a fitting jar", await page.locator("fieldset").nth(1).locator("select").first().inputValue(), jar);
  await page.waitForSelector('body:not([data-case="unchecked"])');
  expect("no fault", await page.locator(".fault-line:not([hidden])").count(), 0);
  await page.click("text=Add a set of balls");
  expect("two sets", (await caseText(page)).match(/\[\[balls\]\]/g).length, 2);
  await page.click('fieldset .remove >> nth=1');
  expect("one set", (await caseText(page)).match(/\[\[balls\]\]/g).length, 1);
}

async function a_link_holds_the_whole_case({ page, context, url }) {
  await open(page, url);
  const text = `${(await caseText(page)).replace("10 Hz", "14 Hz")}\n# Größe: µm, 中\n`;
  await writeCase(page, text);
  await page.click("#share");
  await page.waitForFunction(() => location.hash.startsWith("#case="));
  const other = await context.newPage();
  await other.goto(await page.evaluate(() => location.href));
  await other.waitForSelector("#case-text", { state: "attached" });
  await other.waitForFunction(() => document.querySelector("#case-text").value !== "");
  expect("the same case", await caseText(other), text);
  await other.waitForFunction(() => !document.querySelector("#run").disabled);
  await runAgain(other);
  await other.reload();
  await other.waitForSelector('body[data-case="fine"]');
  expect("the same case after a reload", await caseText(other), text);
}

async function other_line_ends_and_odd_characters_do_no_harm({ page: first, context, url }) {
  await open(first, url);
  const text = await caseText(first);
  const fields = await first.locator(".form .field").count();
  const page = await context.newPage();
  await openCase(page, url, text.replaceAll("\n", "\r\n"));
  expect("lines end as ever", await caseText(page), text);
  expect("fields of the form", await page.locator(".form .field").count(), fields);
  await writeCase(page, `${text}# a\u2028b\u2029c\u0000d\n`);
  expect("faults", await page.locator(".fault-line:not([hidden])").count(), 0);
}

async function what_the_page_lacks_is_said({ page, url, engine }) {
  if (engine === "mock") throw new Skip("the engine of the tests has no limits");
  await open(page, url);
  const text = await caseText(page);
  const fault = () => page.textContent("#case-faults");
  await writeCase(page, text.replace("replicates = 5", "replicates = 5000"));
  expect("replicates", (await fault()).includes("at most 1000 replicates"));
  await writeCase(page, text.replace("count = 1", "count = 100000000").replace('"8 mm"', '"0.002 mm"'));
  expect("balls", (await fault()).includes("at most 100000 balls"));
  await writeCase(page, text.replace('kind = "vibration"', 'kind = "tabulated"\nfile = "motion.csv"')
    .replace(/^(frequency|amplitude) = .*\n/gm, ""));
  expect("a file", (await fault()).includes("the page reads no files"));
  await writeCase(page, `${text}\n[sweep]\n"mill.frequency" = ["8 Hz", "12 Hz"]\n`);
  await tab(page, "about");
  const left = () => page.textContent(".panel-about");
  expect("a section", (await left()).includes("[sweep] is left to the program"));
  await writeCase(page, text.replace("[run]\n", '[run]\nsensitivity = "on"\n'));
  await tab(page, "about");
  expect("runs with other assumed values", (await left()).includes("run.sensitivity is left to the program"));
}

async function a_damaged_link_is_no_fault({ page, url }) {
  await page.goto(`${url}#case=AAAA%%`);
  await ended(page);
  expect("the first example", (await caseText(page)).includes("fritsch-p7-classic"));
}

export const caseTests = [every_example_is_a_case, drawn(every_example_is_drawn),
  drawn(runs_the_first_example_at_once), without_webgl_the_numbers_are_shown,
  a_changed_value_reaches_the_text_and_keeps_comments, settling_is_automatic_without_a_time,
  a_changed_text_reaches_the_form, faults_are_shown_at_their_line, broken_text_does_no_harm,
  a_title_with_markup_does_no_harm, mills_and_jars_can_be_chosen, a_link_holds_the_whole_case,
  a_damaged_link_is_no_fault, a_changed_case_survives_a_reload, back_brings_a_left_case_back,
  engines_that_a_browser_has_not_are_not_offered, parts_motor_and_flow_have_fields, other_line_ends_and_odd_characters_do_no_harm, what_the_page_lacks_is_said];
