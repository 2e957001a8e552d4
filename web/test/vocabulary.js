// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The keys and units of cases, asked of the program: build/release/bin/mahlwerk, or the one that the
// variable MAHLWERK names.

import { execFileSync } from "node:child_process";
import { fileURLToPath } from "node:url";

const program = process.env.MAHLWERK ??
  fileURLToPath(new URL("../../build/release/bin/mahlwerk", import.meta.url));

const listed = (what) => JSON.parse(execFileSync(program, ["list", what, "--json"],
  { encoding: "utf8", maxBuffer: 1 << 26 }));

export const vocabulary = () => ({ keys: listed("keys"), units: listed("units") });
