// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What the tests do again and again on the page. The page's body says in `data-case` whether the case
// is checked, in `data-run` the status of the run, and in `data-runs` how many runs were started.

import { fragmentOf } from "../src/case/share.js";

export const limit = 300e3; // ms; software rendering on a busy machine is slow, a hang is longer

export const ended = (page, status = "done") =>
  page.waitForSelector(`body[data-run="${status}"]`, { timeout: limit });

/// Opens the page and waits for the result of the quickest example.
export async function open(page, url) {
  await page.goto(url);
  await page.waitForSelector("body[data-runs]", { timeout: limit });
  await runAgain(page, () => page.selectOption(".examples select", "vibrating-vial"));
}

/// Opens the page with a case in its link, which is not run.
export async function openCase(page, url, toml) {
  await page.goto(`${url}#${await fragmentOf(toml)}`);
  await page.waitForSelector('body[data-case="fine"]');
}

/// Presses Run, or does `act`, and waits for the end of the run that this starts.
export async function runAgain(page, act = () => page.click("#run"), status = "done") {
  const before = Number(await page.evaluate(() => document.body.dataset.runs ?? 0));
  await act();
  await page.waitForSelector(`body[data-runs="${before + 1}"][data-run="${status}"]`, { timeout: limit })
    .catch(async () => {
      const found = await page.evaluate(() => [JSON.stringify(document.body.dataset),
        document.querySelector("#status").textContent, document.querySelector(".result .title")?.textContent]);
      throw new Error(`run ${before + 1} was not "${status}" in time: ${found.join(", ")}`);
    });
}

/// Opens a tab of the result or of the case by its key.
export const tab = (page, key) => page.click(`#tab-${key}`);

export const caseText = (page) => page.inputValue("#case-text");

/// Replaces the text of the case, as if typed, and waits for the check.
export async function writeCase(page, text) {
  await tab(page, "text");
  await page.fill("#case-text", text);
  await page.waitForSelector('body:not([data-case="unchecked"])');
}

/// Saves the file that `act` downloads as `path`; returns the name that the page gave it.
export async function saved(page, path, act) {
  const [file] = await Promise.all([page.waitForEvent("download"), act()]);
  await file.saveAs(path);
  return file.suggestedFilename();
}

/// Files as a drop gives them.
export const dropped = (page, files) => page.evaluateHandle((all) => {
  const made = new DataTransfer();
  for (const [name, text] of Object.entries(all)) made.items.add(new File([text], name));
  return made;
}, files);
