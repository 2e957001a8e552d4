// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Figures of the page: time to the first collision, pictures per second and the main thread while a case
// is computed, memory.

import { readFileSync } from "node:fs";
import { write } from "../src/case/toml_text.js";
import { withoutWebGL } from "./check.js";
import { median, quantile } from "./median.js";
import { openCase } from "./steps.js";
import { memoryOfPage } from "./test_memory.js";

const long = write(readFileSync(new URL("../examples/planetary-mill.toml", import.meta.url), "utf8"),
  "run.time", "1000 s");
const watched = 10e3; // ms

/// For a page: keeps the time of the first collision, and the long tasks, in `figures`.
const watch = () => {
  globalThis.figures = { longTasks: [] };
  new PerformanceObserver((list) => figures.longTasks.push(...list.getEntries()
    .map(({ startTime, duration }) => ({ startTime, duration })))).observe({ entryTypes: ["longtask"] });
  const seen = new MutationObserver(() => {
    const counted = document.querySelector('.counter[data-key="collisions"] .value')?.textContent ?? "";
    if (!/[1-9]/.test(counted)) return;
    figures.firstCollision = performance.now();
    seen.disconnect();
  });
  seen.observe(document, { subtree: true, childList: true, characterData: true });
};

async function firstCollision(browser, url) {
  const context = await browser.newContext();
  await context.addInitScript(watch);
  const page = await context.newPage();
  await page.goto(url);
  await page.waitForFunction(() => figures.firstCollision);
  const found = await page.evaluate(() => figures.firstCollision);
  await context.close();
  return found;
}

/// Times between pictures, for a page.
const intervals = (duration) => new Promise((resolve) => {
  const list = [];
  const begun = performance.now();
  let before = begun;
  const next = (now) => {
    list.push(now - before);
    before = now;
    if (now - begun < duration) requestAnimationFrame(next);
    else resolve({ begun, list: list.slice(1) });
  };
  requestAnimationFrame(next);
});

async function busyTime(session) {
  const { metrics } = await session.send("Performance.getMetrics");
  const value = (key) => metrics.find(({ name }) => name === key).value;
  return { busy: value("TaskDuration"), script: value("ScriptDuration"), at: value("Timestamp") };
}

/// Watches the page while it computes. `webgl`: whether the replay is drawn, `motion`: whether it plays.
async function whileComputing(browser, url, { name, webgl, motion }) {
  const context = await browser.newContext({ viewport: { width: 1280, height: 800 },
    reducedMotion: motion ? "no-preference" : "reduce" });
  await context.addInitScript(watch);
  if (!webgl) await context.addInitScript(withoutWebGL);
  const page = await context.newPage();
  await openCase(page, url, long);
  await page.click("#run");
  await page.waitForSelector('#replay[data-state]', { timeout: 60e3 });
  await page.waitForTimeout(3000);
  const session = await context.newCDPSession(page);
  await session.send("Performance.enable");
  const before = await busyTime(session);
  const { begun, list } = await page.evaluate(intervals, watched);
  const after = await busyTime(session);
  const all = await page.evaluate(() => figures.longTasks);
  const tasks = all.filter(({ startTime }) => startTime > begun);
  const share = (key) => `${Math.round((100 * (after[key] - before[key])) / (after.at - before.at))} %`;
  const memory = await memoryOfPage(browser);
  const longestOf = (list) => Math.max(0, ...list.map(({ duration }) => duration)).toFixed(0);
  console.log(`${name}: ${(1000 / median(list)).toFixed(0)} pictures/s (median), 95 % within ` +
    `${quantile(list, 0.95).toFixed(0)} ms; main thread busy ${share("busy")} of the time, with scripts ` +
    `${share("script")}; tasks over 50 ms: ${tasks.length}, longest ${longestOf(tasks)} ms, ` +
    `while the page opened ${longestOf(all)} ms; ` +
    `memory ${memory === null ? "unknown" : `${memory.toFixed(0)} MB`}`);
  await context.close();
}

export async function pageFigures(browser, url, turns) {
  const times = [];
  for (let i = 0; i < turns; ++i) times.push(await firstCollision(browser, url));
  console.log(`first collision from disk: ${median(times).toFixed(0)} ms ` +
    `(${Math.min(...times).toFixed(0)} to ${Math.max(...times).toFixed(0)})`);
  await whileComputing(browser, url, { name: "computing, without replay", webgl: false, motion: false });
  await whileComputing(browser, url, { name: "computing, replay stands still", webgl: true, motion: false });
  await whileComputing(browser, url, { name: "computing, replay plays", webgl: true, motion: true });
}
