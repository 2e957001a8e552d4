// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The engine of the page as a program for Node with the commands that tools/check_bits uses:
//   --version | run FOLDER_OR_FILE --out FOLDER [--set KEY=VALUE]... [--quiet] [--jobs N]
// build.js writes it beside the folder `bin` with the WebAssembly file; MAHLWERK_WASM may name another one.

import { mkdirSync, readFileSync, statSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { parseArgs } from "node:util";
import { load } from "../src/engine.js";

const { values, positionals } = parseArgs({ allowPositionals: true, options: {
  version: { type: "boolean" }, quiet: { type: "boolean" }, jobs: { type: "string" },
  out: { type: "string" }, set: { type: "string", multiple: true, default: [] } } });

function fail({ faults }) {
  for (const { where, text, remedy } of faults) console.error(`${where}: ${text}\n    remedy: ${remedy}`);
  process.exit(2);
}

function computed(engine, toml, set, replicate) {
  const opened = engine.open(toml, set, replicate);
  if (opened.faults.length > 0) fail(opened);
  while (!engine.advance(1000).done);
  return engine.state();
}

const wasm = process.env.MAHLWERK_WASM ?? join(dirname(process.argv[1]), "bin/mahlwerk.wasm");
const engine = await load(readFileSync(wasm));
if (values.version) {
  console.log(`mahlwerk ${engine.version} (WebAssembly)`);
} else {
  const place = positionals[1];
  const toml = readFileSync(statSync(place).isDirectory() ? join(place, "case.toml") : place, "utf8");
  const set = values.set.map((text) => text.split(/=(.*)/s).slice(0, 2));
  const checked = engine.check(toml, set);
  if (checked.faults.length > 0) fail(checked);
  const states = Array.from({ length: checked.replicates }, (_, r) => computed(engine, toml, set, r));
  const finished = engine.finish(toml, set, states);
  if (finished.faults.length > 0) fail(finished);
  mkdirSync(values.out, { recursive: true });
  for (const name of finished.files) writeFileSync(join(values.out, name), engine.file(name));
}
