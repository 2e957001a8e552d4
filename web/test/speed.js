// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// How fast the page is, beside the program on the same machine:
//
//   node test/speed.js SITE NATIVE [--turns N] [--only page|cases]
//
// SITE is opened from disk. NATIVE is a `mahlwerk` of the same sources; it computes with one thread.

import { cpus, loadavg } from "node:os";
import { resolve } from "node:path";
import { parseArgs } from "node:util";
import { pathToFileURL } from "node:url";
import { chromium } from "playwright-core";
import { chromiumOptions } from "./browser.js";
import { caseFigures } from "./speed_cases.js";
import { pageFigures } from "./speed_page.js";

const { values, positionals } = parseArgs({ allowPositionals: true, options: {
  turns: { type: "string", default: "5" }, only: { type: "string", default: "" } } });
const [site, native] = positionals.map((path) => resolve(path));
const url = `${pathToFileURL(site)}/index.html`;
const turns = Number(values.turns);

const browser = await chromium.launch(chromiumOptions);
const load = () => `load ${loadavg()[0].toFixed(1)}`;
console.log(`Chromium ${browser.version()}, ${cpus().length} x ${cpus()[0].model}, ${load()} before`);
if (values.only !== "page") await caseFigures(browser, url, native, turns);
if (values.only !== "cases") await pageFigures(browser, url, turns);
console.log(`${load()} after`);
await browser.close();
