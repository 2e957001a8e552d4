// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the page as a whole: accessibility, keyboard, widths, themes, offline, from disk, memory.

import { readFileSync } from "node:fs";
import { caseText, ended, expect, limit, tab } from "./check.js";

const axe = readFileSync(new URL("../node_modules/axe-core/axe.min.js", import.meta.url), "utf8");

const open = async (page, url) => {
  await page.goto(url);
  await ended(page);
};

async function seriousFindings(page) {
  const { violations } = await page.evaluate(`${axe}; axe.run()`);
  return violations.filter(({ impact }) => ["serious", "critical"].includes(impact))
    .map(({ id, nodes }) => `${id}: ${nodes.slice(0, 3).map(({ target }) => target.join(" ")).join(", ")}`);
}

async function axe_has_no_serious_findings({ page, url }) {
  await open(page, url);
  for (const key of ["quantities", "comparison", "sweep", "powder", "about", "files", "text"]) {
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
  expect("arrows change the tab", await page.evaluate(() => document.activeElement.id), "tab-comparison");
  await page.keyboard.press("Control+Enter");
  await page.waitForFunction(() => document.body.dataset.run !== "done");
  await ended(page);
}

async function nothing_is_cut_off({ page, url }) {
  await open(page, url);
  await page.selectOption(".examples select", "planetary-mill"); // four views of the replay
  await page.waitForFunction(() => document.body.dataset.run !== "done");
  await ended(page);
  for (const width of [320, 360, 420, 768, 900, 1280, 1600, 2560]) {
    await page.setViewportSize({ width, height: 800 });
    for (const region of ["case", "result"]) {
      if (width < 900) await page.click(`.regions [data-key="${region}"]`);
      const over = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
      expect(`overflow at ${width}, ${region}`, over <= 0);
      const cut = await page.evaluate(() => [...document.querySelectorAll("#replay button, .counter")]
        .filter((each) => each.getBoundingClientRect().right > innerWidth - 8).length);
      expect(`elements beyond the edge at ${width}, ${region}`, cut, 0);
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
  await page.emulateMedia({ reducedMotion: "reduce" });
  await open(page, url);
  expect("the replay stands still", await page.getAttribute("#replay", "data-playing"), "false");
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
  await page.click("#run");
  await page.waitForFunction(() => document.body.dataset.run !== "done");
  await ended(page);
  await tab(page, "files");
  const [file] = await Promise.all([page.waitForEvent("download"), page.click('.file:text-is("case.toml")')]);
  await file.saveAs(`${folder}/disk.toml`);
  expect("the case", readFileSync(`${folder}/disk.toml`, "utf8").includes('"12 Hz"'));
  await page.click("text=Open the report");
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

async function a_hundred_runs_keep_the_memory({ page, context, url }) {
  await page.emulateMedia({ reducedMotion: "reduce" }); // drawing in software would take most of the time
  await open(page, url);
  const session = await context.newCDPSession(page);
  const memory = async () => {
    await session.send("HeapProfiler.collectGarbage");
    return (await session.send("Runtime.getHeapUsage")).usedSize / 1e6;
  };
  const sizes = [];
  for (let i = 0; i < 100; ++i) {
    await page.click("#run");
    await page.waitForFunction(() => document.body.dataset.run !== "done");
    await ended(page);
    if (i % 10 === 9) sizes.push(await memory());
  }
  console.log(`  heap in MB: ${sizes.map((size) => size.toFixed(1)).join(" ")}`);
  expect("growth below 20 %", sizes.at(-1) < 1.2 * sizes[1]);
}

export const outsideTests = { axe_has_no_serious_findings, the_keyboard_suffices, nothing_is_cut_off,
  the_theme_can_be_switched, motion_can_be_reduced, works_offline_after_the_first_visit };
export const diskTests = { from_disk, a_link_from_disk };
export const longTests = { a_hundred_runs_keep_the_memory };
