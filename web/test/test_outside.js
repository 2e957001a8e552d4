// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the page as a whole: accessibility, keyboard, widths, themes, offline, from disk.

import { readFileSync } from "node:fs";
import { drawn, expect } from "./check.js";
import { caseText, ended, limit, open, runAgain, saved, tab } from "./steps.js";

const axe = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");

export async function seriousFindings(page) {
  const { violations } = await page.evaluate(`${axe}; axe.run()`);
  return violations.filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ target }) => target.join(" ")).join(", ")}`);
}

async function axe_has_no_serious_findings({ page, url }) {
  await open(page, url);
  for (const key of ["quantities", "comparison", "history", "report", "sweep", "about", "files", "text"]) {
    await tab(page, key);
    expect(`findings at ${key}`, await seriousFindings(page), []);
  }
  await page.click("#theme");
  for (const key of ["form", "text", "about"]) {
    await tab(page, key);
    expect(`findings at ${key}, dark`, await seriousFindings(page), []);
  }
}

async function the_keyboard_suffices({ page, url }) {
  await open(page, url);
  await page.keyboard.press("Tab");
  expect("first is the link to the results", await page.evaluate(() => document.activeElement.className),
    "skip");
  await page.keyboard.press("Enter");
  expect("it goes there", await page.evaluate(() => document.activeElement.id), "result");
  await page.focus("#tab-quantities");
  await page.keyboard.press("ArrowRight");
  expect("arrows change the tab", await page.evaluate(() => document.activeElement.id), "tab-report");
  await runAgain(page, () => page.keyboard.press("Control+Enter"));
}

/// Visible elements that reach beyond the edge of the window, of their box or over the header's buttons.
export const cutOff = () => {
  const shown = (list) => [...document.querySelectorAll(list)].filter((each) => each.checkVisibility());
  const right = (each) => each.getBoundingClientRect().right;
  const beyond = shown("#replay button, .counter, .run-bar button, header button, .learn :is(button, td), .field :is(input, select), .quantities :is(th, td)")
    .filter((each) => right(each) > innerWidth - 8 ||
      right(each) > right(each.closest("fieldset, .details, figure, .run-bar, .learn, main") ?? document.body) + 0.5);
  const name = document.querySelector("header h1"), buttons = document.querySelector("header .buttons").getBoundingClientRect();
  if (right(name) > buttons.left && name.getBoundingClientRect().bottom > buttons.top) beyond.push(name);
  return beyond.map((each) => `${each.localName} ${each.textContent || each.className}`);
};

/// Resolves when what changes with the window has been laid out.
export const laidOut = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));

async function nothing_is_cut_off({ page, url }) {
  await open(page, url);
  // This example has four views of the replay.
  await runAgain(page, () => page.selectOption(".examples select", "planetary-mill"));
  for (const width of [320, 360, 420, 768, 900, 1280, 1600, 2560]) {
    await page.setViewportSize({ width, height: 800 });
    await page.evaluate(laidOut);
    for (const region of ["case", "result"]) {
      if (width < 900) await page.click(`.regions [data-key="${region}"]`);
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(`overflow at ${width}, ${region}`, over <= 0);
      expect(`elements beyond the edge at ${width}, ${region}`, await page.evaluate(cutOff), []);
    }
  }
}

async function the_theme_can_be_switched({ page, url }) {
  await page.emulateMedia({ colorScheme: "dark" });
  await open(page, url);
  const theme = () => page.evaluate(() => document.documentElement.dataset.theme);
  expect("as the system", await theme(), "dark");
  await page.click("#theme");
  expect("as chosen", await theme(), "light");
  await page.reload();
  expect("kept", await theme(), "light");
}

async function motion_can_be_reduced({ page, url }) {
  await open(page, url);
  const playing = (value) => page.waitForSelector(`#replay[data-state="drawn"][data-playing="${value}"]`);
  await playing("false");
  await page.emulateMedia({ reducedMotion: "no-preference" });
  await page.reload();
  await playing("true");
}

async function works_offline_after_the_first_visit({ page, context, url }) {
  await open(page, url);
  await page.evaluate(() => navigator.serviceWorker.ready);
  await context.setOffline(true);
  await page.reload();
  await ended(page);
  await context.setOffline(false);
}

async function from_disk({ page, url, folder }) {
  await open(page, url);
  await page.waitForSelector('#replay[data-state="drawn"]', { timeout: limit });
  await page.fill('.field[data-address="mill.frequency"] input[type="number"]', "12");
  await runAgain(page);
  await tab(page, "files");
  await saved(page, `${folder}/disk.toml`, () => page.click('.file:text-is("case.toml")'));
  expect("the case", readFileSync(`${folder}/disk.toml`, "utf8").includes('"12 Hz"'));
  await tab(page, "report");
  await page.frameLocator("iframe").locator("h1").first().waitFor({ timeout: limit });
}

async function a_link_from_disk({ page, context, url }) {
  await open(page, url);
  await page.click("#share");
  await page.waitForFunction(() => location.hash.startsWith("#case="));
  const other = await context.newPage();
  await other.goto(await page.evaluate(() => location.href));
  await other.waitForSelector("#case-text", { state: "attached" });
  await other.waitForFunction(() => document.querySelector("#case-text").value !== "");
  expect("the same case", await caseText(other), await caseText(page));
}

export const outsideTests = [drawn(axe_has_no_serious_findings), drawn(nothing_is_cut_off),
  drawn(motion_can_be_reduced), the_keyboard_suffices, the_theme_can_be_switched,
  works_offline_after_the_first_visit];
export const diskTests = [drawn(from_disk), a_link_from_disk];
