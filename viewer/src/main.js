// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The replay of a report: finds its section and its data on the page, and plays.

import { read } from "./data.js";
import style from "./replay.css";
import { mount } from "./replay.js";

function start() {
  const root = document.getElementById("replay");
  const source = document.getElementById("replay-data");
  if (!root || !source) return;
  document.head.append(Object.assign(document.createElement("style"), { textContent: style }));
  mount(root, () => read(source.textContent));
}

start();
