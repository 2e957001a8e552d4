// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the built page in a headless Chromium:
//
//   node test/run.js [--engine mock|wasm] [--site FOLDER] [--native FILE] [--only WORD] [--long] [--jobs N]
//
// Without --site the page is built into a temporary folder. --native names a `mahlwerk` of the same
// sources, whose results must be those of the page. --long computes 100 runs in a row instead of 20.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { runTests } from "./check.js";
import { serve } from "./server.js";
import { caseTests } from "./test_case.js";
import { estimateTests } from "./test_estimate.js";
import { languageTests } from "./test_languages.js";
import { lessonTests } from "./test_lessons.js";
import { memoryTest } from "./test_memory.js";
import { nativeTests } from "./test_native.js";
import { diskTests, outsideTests } from "./test_outside.js";
import { resultTests } from "./test_result.js";
import { textTests } from "./test_text.js";
import { workTests } from "./test_work.js";

const { values } = parseArgs({ options: { engine: { type: "string", default: "mock" },
  site: { type: "string" }, native: { type: "string" }, only: { type: "string", default: "" },
  jobs: { type: "string", default: "2" }, long: { type: "boolean", default: false } } });
const web = fileURLToPath(new URL("..", import.meta.url));
const temporary = values.site ? null : mkdtempSync(join(tmpdir(), "mahlwerk-site-"));
const site = resolve(values.site ?? temporary);
if (temporary)
  execFileSync("node", [join(web, "build.js"), site, "--engine", values.engine], { stdio: "inherit" });
const begun = Date.now();
await textTests();
languageTests();
const native = values.native ? resolve(values.native) : null;
const server = await serve(site);
const { engine } = values;
const served = { url: server.url, origin: server.url, engine, native };
const disk = `${pathToFileURL(site)}/`;
const chosen = (tests) => tests.filter(({ name }) => name.includes(values.only));
const jobs = Number(values.jobs);
const outcomes = [
  ...await runTests(chosen([...caseTests, ...estimateTests, ...resultTests, ...lessonTests, ...outsideTests, ...workTests,
    ...nativeTests]), served, jobs),
  ...await runTests(chosen(diskTests), { url: `${disk}index.html`, origin: disk }, jobs),
  ...await runTests(chosen([memoryTest(values.long ? 100 : 20)]), served, 1),
];
server.close();
if (temporary) rmSync(temporary, { recursive: true });
const count = (outcome) => outcomes.filter((each) => each === outcome).length;
console.log(`${count("fine")} passed, ${count("unsteady")} passed at the second try, ` +
  `${count("skipped")} skipped, ${count("FAILED")} failed ` +
  `in ${Math.round((Date.now() - begun) / 1000)} s`);
process.exitCode = count("FAILED") > 0 ? 1 : 0;
