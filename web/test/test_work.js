// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the page as a place to work: runs that follow changes, the history, frames in other pages.

import { readFileSync } from "node:fs";
import { drawn, expect, follows } from "./check.js";
import { caseText, ended, limit, open, openCase, runAgain, saved, tab, writeCase } from "./steps.js";

const frequency = '.field[data-address="mill.frequency"] input';
const runs = (page) => page.evaluate(() => Number(document.body.dataset.runs ?? 0));
const entries = (page) => page.locator(".history > li");

async function a_change_restarts_the_run_that_is_computed({ page, url }) {
  await open(page, url);
  const text = await caseText(page);
  await writeCase(page, text.replace("replicates = 5", "replicates = 60"));
  await ended(page, "computing");
  const before = await runs(page);
  await writeCase(page, text.replace('"10 Hz"', '"17 Hz"'));
  await page.waitForSelector(`body[data-runs="${before + 1}"]`);
  await ended(page);
  expect("no run is of another case", await page.isVisible(".stale"), false);
  await tab(page, "history");
  expect("the result is that of the change", (await entries(page).first().textContent()).includes("mill.frequency = 17 Hz"));
  expect("the run before left no result", await entries(page).count(), 3);
}

async function after_a_quick_result_a_change_starts_the_next({ page, url }) {
  await open(page, url);
  await runAgain(page, async () => {
    await page.locator(`${frequency}[type="range"]`).focus();
    await page.keyboard.press("ArrowRight");
  });
  expect("it is of the case", await page.isVisible(".stale"), false);
}

async function nothing_starts_by_itself_after_stop_with_a_fault_or_when_it_is_off({ page, url }) {
  await open(page, url);
  const fine = await caseText(page);
  await page.uncheck("#follow");
  await writeCase(page, fine.replace('"10 Hz"', '"11 Hz"').replace("replicates = 5", "replicates = 12"));
  await page.waitForTimeout(1000);
  expect("off", await runs(page), 2);
  expect("the result is said to be another", await page.isVisible(".stale"));
  await page.reload();
  await page.waitForSelector('body[data-case="fine"]');
  expect("the choice is kept", await page.isChecked("#follow"), false);
  await page.check("#follow");
  await page.click("#run");
  await ended(page, "computing");
  await page.click("#stop");
  await ended(page, "stopped");
  await writeCase(page, fine);
  await page.waitForTimeout(1000);
  expect("after Stop", await runs(page), 1);
  await runAgain(page);
  await writeCase(page, fine.replace("[jar]\n", "[jar]\nshape = 3\n"));
  await page.waitForTimeout(1000);
  expect("with a fault", await runs(page), 2);
}

async function any_two_results_are_compared({ page, url }) {
  await open(page, url);
  for (const value of ["12", "14"]) {
    await page.fill(`${frequency}[type="number"]`, value);
    await runAgain(page);
  }
  await tab(page, "history");
  expect("results, the first example's among them", await entries(page).count(), 4);
  expect("what changed", (await entries(page).nth(0).textContent()).includes("mill.frequency = 14 Hz"));
  await entries(page).nth(2).locator('.choice button:text-is("A")').click();
  await entries(page).nth(1).locator('.choice button:text-is("B")').click();
  await tab(page, "comparison");
  expect("both", (await page.textContent(".panel-comparison .note")).includes("mill.frequency from 10 Hz to 12 Hz"));
  expect("the power differs", await page.locator(".comparison tbody tr .verdict").first().textContent(), "differ");
  expect("their spectra", await page.locator(".panel-comparison canvas").count() > 0);
  await page.locator(".panel-comparison select").nth(1).selectOption({ label: "the newest result" });
  expect("the newest", (await page.textContent(".panel-comparison .note")).includes("from 10 Hz to 14 Hz"));
}

async function a_saved_result_is_there_after_a_reload({ page, url, folder }) {
  await open(page, url);
  const power = await page.textContent('.counter[data-key="power"] .value');
  await tab(page, "history");
  await page.fill(".saving input", "My vial");
  await page.click("text=Save this case");
  await page.waitForFunction(() => document.querySelector(".panel-history [role=status]").textContent.startsWith("Saved"));
  await page.reload();
  await ended(page);
  await tab(page, "history");
  const mine = entries(page).filter({ hasText: "My vial" });
  await mine.locator("text=Rename").click();
  await page.keyboard.type("Vial at 10 Hz");
  await page.keyboard.press("Enter");
  await page.waitForFunction(() => document.querySelector(".history").textContent.includes("Vial at 10 Hz"));
  const renamed = entries(page).filter({ hasText: "Vial at 10 Hz" });
  await saved(page, `${folder}/case.toml`, () => renamed.locator("text=case.toml").click());
  expect("its case", readFileSync(`${folder}/case.toml`, "utf8").includes('"10 Hz"'));
  await renamed.locator('button:text-is("Open")').click();
  await page.waitForFunction(() => document.querySelector("#status").textContent.startsWith("Opened: "));
  expect("its power", await page.textContent('.counter[data-key="power"] .value'), power);
  await tab(page, "report");
  await page.frameLocator("iframe").locator("h1").first().waitFor({ timeout: limit });
  await tab(page, "history");
  await renamed.locator("text=Delete").click();
  await page.reload();
  await page.waitForSelector('body[data-case="fine"]');
  await page.waitForTimeout(300);
  expect("it is gone", (await page.textContent(".panel-history")).includes("Vial at 10 Hz"), false);
}

async function without_storage_the_history_holds_the_session({ page, url }) {
  await page.addInitScript(() => Object.defineProperty(globalThis, "indexedDB",
    { get: () => { throw new DOMException("denied", "SecurityError"); } }));
  await open(page, url);
  await tab(page, "history");
  expect("it says so", (await page.textContent(".panel-history")).includes("lets the page keep nothing"));
  await page.click("text=Save this case");
  await page.waitForFunction(() => document.querySelector(".panel-history [role=status]").textContent
    .includes("until the page is closed"));
  expect("results", await entries(page).count(), 2);
}

async function a_frame_shows_the_replay_and_a_link({ page, context, url }) {
  await open(page, url);
  await page.click("#share");
  const html = await page.inputValue(".share-panel textarea");
  await page.keyboard.press("Escape");
  expect("Escape closes", await page.isVisible(".share-panel"), false);
  const address = /src="([^"]*)"/.exec(html)[1].replaceAll("&amp;", "&");
  const frame = await context.newPage();
  await frame.setViewportSize({ width: 420, height: 736 });
  await frame.goto(address);
  await frame.waitForSelector('body[data-embed][data-case="fine"]');
  await frame.waitForSelector('#replay[data-state="drawn"]', { timeout: limit });
  expect("no run by itself", await runs(frame), 0);
  for (const hidden of ["header", ".case", ".details", ".plots", "footer", ".follow"])
    expect(hidden, await frame.isVisible(hidden), false);
  expect("no overflow", await frame.evaluate(() => document.documentElement.scrollWidth <= innerWidth));
  await runAgain(frame);
  const [full] = await Promise.all([context.waitForEvent("page"), frame.click("text=Open in full")]);
  await full.waitForSelector('body[data-case="fine"]');
  expect("the same case in full", [await caseText(full) === await caseText(page), await full.isVisible("header")], [true, true]);
  const begun = await context.newPage();
  await begun.goto(address.replace("#embed&", "#embed&run&"));
  await begun.waitForSelector("body[data-embed][data-runs]");
}

async function the_replay_shows_spins_energies_and_hits({ page, url }) {
  await openCase(page, url, readFileSync(new URL("../examples/planetary-mill.toml", import.meta.url), "utf8"));
  await runAgain(page);
  await page.waitForSelector('#replay[data-state="drawn"]');
  await page.waitForFunction(() => document.querySelector("#replay").dataset.hits === "off", null, { timeout: limit });
  for (const key of ["spin", "energy"]) {
    await page.click(`#replay [data-key="${key}"]`);
    await page.waitForSelector(`#replay[data-colour="${key}"]`);
  }
  await page.focus("#replay .scene");
  await page.keyboard.press("h");
  await page.waitForFunction(() => document.querySelector("#replay").dataset.hits >= 0, null, { timeout: limit });
}

/// The first bytes of a saved file, as text.
const begins = async (page, path, act) => {
  await saved(page, path, act);
  return readFileSync(path).subarray(0, 4).toString("latin1");
};

async function pictures_and_a_video_can_be_saved({ page, url, folder }) {
  await open(page, url);
  await page.waitForSelector('#replay[data-state="drawn"]', { timeout: limit });
  const plot = page.locator(".plots .chart-tools").first();
  expect("a plot as PNG", await begins(page, `${folder}/a.png`, () => plot.locator("text=PNG").click()), "\x89PNG");
  expect("a plot as SVG", await begins(page, `${folder}/a.svg`, () => plot.locator("text=SVG").click()), "<svg");
  expect("the replay as PNG", await begins(page, `${folder}/b.png`, () => page.click("#replay >> text=Picture")), "\x89PNG");
  const pace = page.locator("#replay select");
  await pace.selectOption(await pace.evaluate(({ options }) => options[Math.max(options.length - 3, 0)].value)); // some 5 s
  expect("the replay as WebM", await begins(page, `${folder}/b.webm`, () => page.click("#replay >> text=Video")),
    "\x1aE\xdf\xa3");
}

export const workTests = [follows(a_change_restarts_the_run_that_is_computed),
  follows(after_a_quick_result_a_change_starts_the_next),
  follows(nothing_starts_by_itself_after_stop_with_a_fault_or_when_it_is_off), any_two_results_are_compared,
  a_saved_result_is_there_after_a_reload, without_storage_the_history_holds_the_session,
  drawn(a_frame_shows_the_replay_and_a_link), drawn(the_replay_shows_spins_energies_and_hits),
  drawn(pictures_and_a_video_can_be_saved)];
