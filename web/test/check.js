// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A list of tests with one browser, and what they share.

import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";
import { chromiumOptions } from "./browser.js";

export const limit = 120e3; // ms; software rendering on a busy machine is slow

/// Throws unless `found` is the one wanted value, or true if none is given.
export function expect(what, found, ...rest) {
  const wanted = rest.length > 0 ? rest[0] : true;
  const same = JSON.stringify(found) === JSON.stringify(wanted);
  if (!same) throw new Error(`${what}: found ${JSON.stringify(found)}, expected ${JSON.stringify(wanted)}`);
}

export const ended = (page, status = "done") =>
  page.waitForSelector(`body[data-run="${status}"]`, { timeout: limit });

/// Opens a tab of the result or of the case by its key.
export const tab = (page, key) => page.click(`#tab-${key}`);

export const caseText = (page) => page.inputValue("#case-text");

/// Replaces the text of the case, as if typed, and waits for the check.
export async function writeCase(page, text) {
  await tab(page, "text");
  await page.fill("#case-text", text);
  await page.waitForTimeout(800);
}

export async function runTests(tests, { url, only, origin }) {
  const profile = mkdtempSync(join(tmpdir(), "mahlwerk-page-"));
  const browser = await chromium.launch(chromiumOptions);
  const chosen = Object.entries(tests).filter(([name]) => !only || name.includes(only));
  let failed = 0;
  for (const [name, test] of chosen) {
    const permissions = url.startsWith("http") ? ["clipboard-read", "clipboard-write"] : [];
    const context = await browser.newContext({ viewport: { width: 1280, height: 800 },
      acceptDownloads: true, permissions });
    context.setDefaultTimeout(limit);
    const faults = [];
    const follow = (page) => {
      page.on("request", (request) => {
        const address = request.url();
        if (!/^(blob|data):/.test(address) && !address.startsWith(origin)) faults.push(`request to ${address}`);
      });
      page.on("pageerror", (error) => faults.push(String(error)));
      page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
    };
    context.on("page", follow);
    try {
      await test({ page: await context.newPage(), context, url, folder: profile });
      expect("errors and foreign requests", faults, []);
      console.log(`fine: ${name}`);
    } catch (error) {
      ++failed;
      console.log(`FAILED: ${name}: ${error.message.split("\n").slice(0, 6).join("\n  ")}`, faults);
    }
    await context.close();
  }
  await browser.close();
  rmSync(profile, { recursive: true, force: true });
  console.log(`${chosen.length - failed} passed, ${failed} failed`);
  return failed;
}
