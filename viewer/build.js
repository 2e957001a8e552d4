// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bundles src/ and the required parts of three.js into dist/replay.js, and writes the licences.

import { readFileSync, writeFileSync } from "node:fs";
import { build } from "esbuild";

const ourLicence = "Mahlwerk: Copyright 2026 The Mahlwerk authors, Apache License 2.0";
const { version } = JSON.parse(readFileSync("node_modules/three/package.json", "utf8"));
const mit = readFileSync("node_modules/three/LICENSE", "utf8").trim();
const viridis = "viridis (ten colours in src/colours.js): S. van der Walt and N. Smith, " +
  "matplotlib, CC0 1.0";
const licences = `${ourLicence}\n${viridis}\nthree.js ${version}, https://threejs.org:\n\n${mit}\n`;

const { metafile } = await build({
  entryPoints: ["src/main.js"],
  outfile: "dist/replay.js",
  bundle: true,
  minify: true,
  format: "iife",
  target: ["chrome100", "firefox110", "safari16"],
  loader: { ".css": "text" },
  legalComments: "none",
  charset: "ascii",
  banner: { js: `/*!\n${licences}*/` },
  metafile: true,
});

// The bundle may contain only src/ and three.js, because only their licences are named above.
const stranger = Object.keys(metafile.inputs)
  .find((path) => !path.startsWith("src/") && !path.startsWith("node_modules/three/"));
const code = readFileSync("dist/replay.js", "utf8");
if (stranger) throw new Error(`${stranger} is bundled, but its licence is not named in build.js`);
if (/<\/script|<!--/i.test(code)) throw new Error("dist/replay.js would end its <script> element");
writeFileSync("dist/LICENSES.txt", licences);
console.log(`dist/replay.js: ${Math.ceil(code.length / 1000)} kB`);
