// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Many runs in a row keep the memory.

import { readFileSync } from "node:fs";
import { expect } from "./check.js";
import { caseText, open, runAgain, writeCase } from "./steps.js";

/// Memory in MB of the largest process that shows a page: the page, its workers and WebAssembly. Null
/// without /proc.
export async function memoryOfPage(browser) {
  const session = await browser.newBrowserCDPSession();
  const { processInfo } = await session.send("SystemInfo.getProcessInfo");
  await session.detach();
  try {
    return Math.max(...processInfo.filter(({ type }) => type === "renderer").map(({ id }) =>
      Number(readFileSync(`/proc/${id}/smaps_rollup`, "utf8").match(/^Pss: +(\d+) kB/m)[1]) / 1e3));
  } catch {
    return null;
  }
}

async function heapOf(session) {
  await session.send("HeapProfiler.collectGarbage");
  return (await session.send("Runtime.getHeapUsage")).usedSize / 1e6;
}

/// Whether the lowest of the second half is below 1.2 times that of the first without its beginning. Single
/// samples rise and fall by a fifth with the garbage that the browser has not yet collected.
const keeps = (samples) => Math.min(...samples.slice(5)) < 1.2 * Math.min(...samples.slice(1, 5));

/// `count` runs of a short case. The browser shows no other page meanwhile.
export const memoryTest = (count) => async function many_runs_keep_the_memory({ page, context, url, note }) {
  await open(page, url);
  await writeCase(page, (await caseText(page)).replace('time = "60 s"', 'time = "5 s"')
    .replace("replicates = 5", "replicates = 2"));
  const session = await context.newCDPSession(page);
  const heaps = [];
  const all = [];
  for (let i = 0; i < count; ++i) {
    await runAgain(page);
    if (i % (count / 10) !== count / 10 - 1) continue;
    heaps.push(await heapOf(session));
    all.push(await memoryOfPage(context.browser()));
  }
  note(`heap of the page in MB: ${heaps.map((size) => size.toFixed(1)).join(" ")}`);
  expect("growth of the heap below 20 %", keeps(heaps));
  if (all[0] === null) return note("the memory of the processes is not known here");
  note(`page, workers and WebAssembly in MB: ${all.map((size) => size.toFixed(0)).join(" ")}`);
  expect("growth of all memory below 20 %", keeps(all));
  expect("all memory below 300 MB", all.at(-1) < 300);
};
