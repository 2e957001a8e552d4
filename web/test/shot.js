// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Pictures of the built page for looking at: node test/shot.js SITE FOLDER

import { chromium } from "playwright-core";
import { chromiumOptions } from "./browser.js";
import { serve } from "./server.js";

const [site, folder, only] = process.argv.slice(2);
const server = await serve(site);
const browser = await chromium.launch(chromiumOptions);
const views = [[1280, 800, "light"], [1280, 800, "dark"], [1920, 1080, "light"], [420, 860, "light"],
  [360, 740, "dark"]].filter(([width]) => !only || String(width) === only);
for (const [width, height, colorScheme] of views) {
  const context = await browser.newContext({ viewport: { width, height }, colorScheme });
  const page = await context.newPage();
  page.on("console", (message) => message.type() === "error" && console.log(message.text()));
  page.on("pageerror", (error) => console.log(error.stack));
  const begun = Date.now();
  await page.goto(server.url);
  await page.waitForSelector('body[data-run="done"]', { timeout: 60000 });
  console.log(width, colorScheme, Date.now() - begun, "ms to the first result");
  await page.waitForTimeout(1500);
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
