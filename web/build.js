// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Writes the page into a folder:
//
//   node build.js [FOLDER] [--engine wasm|mock] [--bin FOLDER] [--command FILE]
//   node build.js --plots
//
// The second form writes dist/plots.js, which draws the plots of reports. It is committed, so that Mahlwerk builds
// without Node.
// The engine `wasm` is src/engine.js with mahlwerk.js and mahlwerk.wasm of the folder `bin` (default
// ../build/web/bin); `mock` is test/mock_engine.js, for tests of the page alone. `command`: where
// test/command.js is written for Node; left out, it is not.

import { createHash } from "node:crypto";
import { cpSync, mkdirSync, readFileSync, readdirSync, rmSync, statSync, writeFileSync } from "node:fs";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";
import { parseArgs } from "node:util";
import { deflateRawSync } from "node:zlib";
import { build } from "esbuild";
import { vocabulary } from "./test/vocabulary.js";

const here = fileURLToPath(new URL(".", import.meta.url));
const target = ["chrome103", "firefox113", "safari16.4"];
const order = ["planetary-mill", "tumbling-drum", "mixer-mill", "shaker-mill", "vibrating-vial", "quartz"];

/// Modules that are made here: "worker-source", "example-cases", "lesson-cases", "test-vocabulary", and the engine.
function made(modules) {
  return { name: "made", setup(task) {
    task.onResolve({ filter: /^(worker-source|example-cases|lesson-cases|test-vocabulary)$/ }, ({ path }) => ({ path, namespace: "made" }));
    task.onLoad({ filter: /.*/, namespace: "made" },
      ({ path }) => ({ contents: JSON.stringify(modules[path]), loader: "json" }));
  } };
}

/// Finds the engine, and the module that the compiler has written for it.
const chosenEngine = (path, bin) => ({ name: "engine", setup(task) {
  task.onResolve({ filter: /\/engine\.js$/ }, () => ({ path }));
  task.onResolve({ filter: /^mahlwerk-module$/ }, () => ({ path: join(bin, "mahlwerk.js") }));
} });

function options(entry, plugins) {
  return { entryPoints: [join(here, entry)], bundle: true, minify: true, format: "iife", target,
    legalComments: "none", charset: "utf8", write: false, outdir: "out", metafile: true, plugins,
    nodePaths: [join(here, "node_modules")], absWorkingDir: here,
    external: ["node:*", "fs", "path", "url", "module"], define: { "import.meta.url": "''" } };
}

async function workerSource(plugins) {
  const { outputFiles } = await build(options("src/worker.js", plugins));
  return outputFiles[0].text;
}

const writeCommand = (outfile, plugins) => build({ ...options("test/command.js", plugins), outdir: undefined,
  outfile: resolve(outfile), write: true, format: "esm", platform: "node", target: "node20" });

const cases = (folder, names) => Object.fromEntries(names.map((name) =>
  [name, readFileSync(join(here, folder, `${name}.toml`), "utf8")]));
const lessonNames = () => readdirSync(join(here, "lessons")).map((name) => name.replace(/\.toml$/, ""));

/// Licences of what is bundled. Packages that are not named here stop the build.
function licences(metafile) {
  const packages = { three: "https://threejs.org", uplot: "https://github.com/leeoniya/uPlot" };
  const used = new Set(Object.keys(metafile.inputs)
    .map((path) => path.match(/node_modules\/((?:@[^/]+\/)?[^/]+)/)?.[1]).filter(Boolean));
  const texts = [...used].sort().map((name) => {
    if (!(name in packages)) throw new Error(`${name} is bundled, but its licence is not named in build.js`);
    const folder = join(here, "node_modules", name);
    const { version } = JSON.parse(readFileSync(join(folder, "package.json"), "utf8"));
    return `${name} ${version}, ${packages[name]}:\n\n${readFileSync(join(folder, "LICENSE"), "utf8").trim()}\n`;
  });
  return ["Mahlwerk: Copyright 2026 The Mahlwerk authors, Apache License 2.0\n" +
    "viridis (ten colours of the replay and of maps): S. van der Walt and N. Smith, matplotlib, CC0 1.0\n",
  ...texts].join("\n");
}

function writeServiceWorker(folder) {
  const names = readdirSync(folder).filter((name) => name !== "sw.js" && statSync(join(folder, name)).isFile());
  const hash = createHash("sha256");
  for (const name of names.sort()) hash.update(name).update(readFileSync(join(folder, name)));
  const list = ["./", ...names].map((name) => JSON.stringify(name)).join(", ");
  const source = readFileSync(join(here, "static/sw.js"), "utf8")
    .replace('"VERSION"', `"mahlwerk-${hash.digest("hex").slice(0, 16)}"`).replace("/* FILES */", list);
  writeFileSync(join(folder, "sw.js"), source);
}

/// Writes the script of reports. It stands inside a <script> element.
async function writePlots() {
  const { outputFiles, metafile } = await build({ ...options("src/report.js", []), loader: { ".css": "text" },
    charset: "ascii" });
  const code = outputFiles[0].text;
  if (/<\/script|<!--/i.test(code)) throw new Error("dist/plots.js would end its <script> element");
  mkdirSync(join(here, "dist"), { recursive: true });
  const terms = licences(metafile);
  writeFileSync(join(here, "dist/LICENSES.txt"), terms);
  writeFileSync(join(here, "dist/plots.js"), `/*!\n${terms}*/\n${code}`);
  console.log(`dist/plots.js: ${Math.ceil(code.length / 1000)} kB`);
}

async function main() {
  const { values, positionals } = parseArgs({ allowPositionals: true, options: {
    plots: { type: "boolean", default: false },
    engine: { type: "string", default: "wasm" },
    bin: { type: "string", default: join(here, "../build/web/bin") }, command: { type: "string" } } });
  if (values.plots) return writePlots();
  const folder = resolve(positionals[0] ?? join(here, "../build/web/site"));
  const mock = values.engine === "mock";
  const engine = join(here, mock ? "test/mock_engine.js" : "src/engine.js");
  const bin = resolve(values.bin);
  const wasm = mock ? Buffer.alloc(0) : readFileSync(join(bin, "mahlwerk.wasm"));
  const plugins = [chosenEngine(engine, bin)];
  if (mock) plugins.push(made({ "test-vocabulary": vocabulary() }));
  const modules = { "worker-source": await workerSource(plugins), "example-cases": cases("examples", order),
    "lesson-cases": cases("lessons", lessonNames()) };
  const { outputFiles, metafile } = await build(options("src/main.js", [made(modules)]));
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  cpSync(join(here, "static"), folder, { recursive: true });
  for (const { path, contents } of outputFiles)
    writeFileSync(join(folder, path.endsWith(".css") ? "page.css" : "page.js"), contents);
  writeFileSync(join(folder, "mahlwerk.wasm.js"),
    `globalThis.MAHLWERK_WASM = "${deflateRawSync(wasm, { level: 9 }).toString("base64")}";\n`);
  writeFileSync(join(folder, "LICENSES.txt"), licences(metafile));
  writeServiceWorker(folder);
  if (values.command) await writeCommand(values.command, plugins);
  const size = (name) => `${name} ${Math.ceil(statSync(join(folder, name)).size / 1000)} kB`;
  console.log(`${folder}: ${["page.js", "page.css", "mahlwerk.wasm.js"].map(size).join(", ")}`);
}

await main();
