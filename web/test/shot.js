// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Pictures of the built page for looking at:
//
//   node test/shot.js SITE FOLDER [--width N] [--example NAME]

import { readFileSync } from "node:fs";
import { parseArgs } from "node:util";
import { chromium } from "playwright-core";
import { chromiumOptions } from "./browser.js";
import { serve } from "./server.js";
import { ended, open, openCase, runAgain } from "./steps.js";

const { values, positionals: [site, folder] } = parseArgs({ allowPositionals: true,
  options: { width: { type: "string" }, example: { type: "string" } } });
const server = await serve(site);
const browser = await chromium.launch(chromiumOptions);
const views = [[320, 700, "light"], [320, 700, "dark"], [420, 860, "light"], [420, 860, "dark"], [768, 1000, "light"],
  [900, 800, "light"], [1280, 800, "light"], [1280, 800, "dark"], [1920, 1080, "light"]]
  .filter(([width]) => !values.width || String(width) === values.width);

async function showCase(page) {
  if (!values.example) return open(page, server.url);
  const path = new URL(`../examples/${values.example}.toml`, import.meta.url);
  await openCase(page, server.url, readFileSync(path, "utf8"));
  await runAgain(page);
}

for (const [width, height, colorScheme] of views) {
  const context = await browser.newContext({ viewport: { width: 1280, height }, colorScheme, reducedMotion: "reduce" });
  const page = await context.newPage();
  page.on("console", (message) => message.type() === "error" && console.log(message.text()));
  page.on("pageerror", (error) => console.log(error.stack));
  await showCase(page);
  await ended(page);
  await page.setViewportSize({ width, height });
  await page.waitForSelector('#replay[data-state="drawn"]');
  const name = (what) => `${folder}/${width}-${colorScheme}-${what}.png`;
  await page.screenshot({ path: name("top") });
  await page.screenshot({ path: name("full"), fullPage: true });
  if (width < 900) {
    await page.click('.regions [data-key="case"]');
    await page.screenshot({ path: name("case"), fullPage: true });
  }
  await context.close();
}
await browser.close();
server.close();
