// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tests of the built page in a headless Chromium:
//
//   node test/run.js [--engine mock|wasm] [--site FOLDER] [--only WORD] [--long]
//
// Without --site the page is built into a temporary folder. --long adds 100 runs in a row.

import { execFileSync } from "node:child_process";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath, pathToFileURL } from "node:url";
import { parseArgs } from "node:util";
import { runTests } from "./check.js";
import { serve } from "./server.js";
import { caseTests } from "./test_case.js";
import { diskTests, longTests, outsideTests } from "./test_outside.js";
import { resultTests } from "./test_result.js";
import { textTests } from "./test_text.js";

const { values } = parseArgs({ options: { engine: { type: "string", default: "mock" },
  site: { type: "string" }, only: { type: "string" }, long: { type: "boolean", default: false } } });
const web = fileURLToPath(new URL("..", import.meta.url));
const temporary = values.site ? null : mkdtempSync(join(tmpdir(), "mahlwerk-site-"));
const site = resolve(values.site ?? temporary);
if (temporary)
  execFileSync("node", [join(web, "build.js"), site, "--engine", values.engine], { stdio: "inherit" });
textTests();
const server = await serve(site);
const { only } = values;
let failed = await runTests({ ...caseTests, ...resultTests, ...outsideTests,
  ...(values.long ? longTests : {}) }, { url: server.url, origin: server.url, only });
const disk = `${pathToFileURL(site)}/`;
failed += await runTests(diskTests, { url: `${disk}index.html`, origin: disk, only });
server.close();
if (temporary) rmSync(temporary, { recursive: true });
process.exitCode = failed > 0 ? 1 : 0;
