// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The simulator: the functions of web/core/exports.cpp with texts and objects as arguments. One
// Engine computes one replicate at a time; it blocks its thread while it does.

import create from "mahlwerk-module"; // build/web/bin/mahlwerk.js, which the compiler writes (build.js)

export async function load(wasmBytes) {
  return new Engine(await create({ wasmBinary: wasmBytes }));
}

class Engine {
  constructor(module) {
    this.module = module;
  }

  get version() {
    return this.text("version");
  }

  vocabulary() {
    return this.object("vocabulary");
  }

  /// `words`: mill, jar, material, balls, frequency or speed, powder, time; what is empty is left out.
  estimate(words) {
    return this.object("estimate", JSON.stringify(words));
  }

  check(toml, set = []) {
    const found = this.object("check", toml, lines(set));
    if (found.faults.length > 0) return found;
    return { ...found, film: this.object("picture", toml, lines(set)) };
  }

  open(toml, set = [], replicate = 0) {
    return this.object("open", toml, lines(set), replicate);
  }

  advance(milliseconds) {
    return unlessFaults(this.object("advance", milliseconds));
  }

  summary() {
    return unlessFaults(this.object("summary"));
  }

  table(name) {
    return this.text("table", name);
  }

  film() {
    return this.object("film");
  }

  state() {
    const at = this.call("state");
    return this.module.HEAPU8.slice(at, at + this.module._mahlwerk_answer_size());
  }

  finish(toml, set, states) {
    for (const state of states) {
      const at = this.module._mahlwerk_add_state(state.length);
      this.module.HEAPU8.set(state, at);
    }
    return this.object("finish", toml, lines(set));
  }

  file(name) {
    return this.text("file", name);
  }

  text(name, ...given) {
    const at = this.call(name, ...given);
    return this.module.UTF8ToString(at);
  }

  object(name, ...given) {
    return JSON.parse(this.text(name, ...given));
  }

  // Calls a function of the simulator; texts are copied into its memory for the time of the call.
  call(name, ...given) {
    const copies = [];
    const passed = given.map((value) => {
      if (typeof value !== "string") return value;
      const size = this.module.lengthBytesUTF8(value) + 1;
      const at = this.module._malloc(size);
      this.module.stringToUTF8(value, at, size);
      copies.push(at);
      return at;
    });
    try {
      return this.module[`_mahlwerk_${name}`](...passed);
    } finally {
      copies.forEach((at) => this.module._free(at));
    }
  }
}

// "key=value" lines, as the command line takes them with --set.
function lines(set) {
  return set.map(([key, value]) => `${key}=${value}`).join("\n");
}

function unlessFaults(answer) {
  if (answer?.faults?.length > 0) throw new Error(answer.faults[0].text);
  return answer;
}
