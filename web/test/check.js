// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs tests in a browser, several at a time.

import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { chromium } from "playwright-core";
import { chromiumOptions } from "./browser.js";
import { limit } from "./steps.js";

/// Throws unless `found` is the one wanted value, or true if none is given.
export function expect(what, found, ...rest) {
  const wanted = rest.length > 0 ? rest[0] : true;
  const same = JSON.stringify(found) === JSON.stringify(wanted);
  if (!same) throw new Error(`${what}: found ${JSON.stringify(found)}, expected ${JSON.stringify(wanted)}`);
}

/// Marks a test that looks at the replay. The others run as in a browser without WebGL 2, because
/// drawing in software takes most of the time.
export const drawn = (test) => Object.assign(test, { drawn: true });

/// Marks a test in which a changed case may run by itself. In the others only Run and examples start runs.
export const follows = (test) => Object.assign(test, { follows: true });

/// For a page: "Run follows changes" is off.
const runsOnlyWhenAsked = () => {
  try {
    localStorage.setItem("mahlwerk-follow", "off");
  } catch {
    // a page without storage
  }
};

/// A test that throws this is skipped, and the reason is shown.
export class Skip extends Error {}

/// For a page: makes it a browser without WebGL 2.
export const withoutWebGL = () => {
  const original = HTMLCanvasElement.prototype.getContext;
  HTMLCanvasElement.prototype.getContext = function (kind, ...rest) {
    return kind === "webgl2" ? null : original.call(this, kind, ...rest);
  };
};

/// A context of the browser, and the list of the errors and foreign requests in it.
async function freshContext(browser, { test, url, origin }) {
  const permissions = url.startsWith("http") ? ["clipboard-read", "clipboard-write"] : [];
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 },
    acceptDownloads: true, permissions, reducedMotion: "reduce" });
  context.setDefaultTimeout(limit);
  if (!test.follows) await context.addInitScript(runsOnlyWhenAsked);
  if (!test.drawn) await context.addInitScript(withoutWebGL);
  const faults = [];
  context.on("request", (request) => {
    const address = request.url();
    if (!/^(blob|data):/.test(address) && !address.startsWith(origin)) faults.push(`request to ${address}`);
  });
  context.on("page", (page) => {
    page.on("pageerror", (error) => faults.push(String(error)));
    page.on("console", (message) => message.type() === "error" && faults.push(message.text()));
  });
  return { context, faults };
}

/// Runs one test; returns "fine", "skipped" or "FAILED".
async function runTest(browser, given) {
  const { name, test, url, engine, native } = given;
  const begun = Date.now();
  const { context, faults } = await freshContext(browser, given);
  const folder = mkdtempSync(join(tmpdir(), "mahlwerk-page-"));
  const notes = [];
  let outcome = "fine";
  try {
    const page = await context.newPage();
    page.on("dialog", (dialog) => dialog.accept()); // of changes that are left
    await test({ page, context, url, folder, engine, native,
      note: (text) => notes.push(text) });
    expect("errors and foreign requests", faults, []);
  } catch (error) {
    outcome = error instanceof Skip ? "skipped" : "FAILED";
    notes.push(error.message.split("\n").slice(0, 6).join("\n  "), ...faults);
  }
  const seconds = ((Date.now() - begun) / 1000).toFixed(1);
  console.log([`${outcome}: ${name}, ${seconds} s`, ...notes].join("\n  "));
  await context.close();
  rmSync(folder, { recursive: true, force: true });
  return outcome;
}

/// `tests`: list of functions, named by what they prove. `given`: url, origin, engine, native (a program or
/// null). `jobs`: how many run at the same time. A test that failed runs once more, alone, in a fresh browser:
/// if it passes there, its outcome is "unsteady", and what it said first stays in the log.
export async function runTests(tests, given, jobs) {
  const browser = await chromium.launch(chromiumOptions);
  const queue = [...tests], failed = [], outcomes = [];
  const worker = async () => {
    while (queue.length > 0) {
      const test = queue.shift();
      const outcome = await runTest(browser, { ...given, test, name: test.name });
      if (outcome === "FAILED") failed.push(test);
      else outcomes.push(outcome);
    }
  };
  await Promise.all(Array.from({ length: jobs }, worker));
  await browser.close();
  for (const test of failed) outcomes.push(await secondTry(test, given));
  return outcomes;
}

async function secondTry(test, given) {
  const browser = await chromium.launch(chromiumOptions);
  const outcome = await runTest(browser, { ...given, test, name: `${test.name} (second try)` });
  await browser.close();
  return outcome === "fine" ? "unsteady" : outcome;
}
