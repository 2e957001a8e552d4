// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// A worker with an engine, as seen by the page.

import workerSource from "worker-source";
import { fromBase64, inflate } from "../base64.js";

let bytes = null;

/// The bytes of the WebAssembly module, from the script that embeds them.
const wasmBytes = () =>
  (bytes ??= inflate(fromBase64(globalThis.MAHLWERK_WASM ?? "")));

const address = () =>
  URL.createObjectURL(new Blob([workerSource], { type: "text/javascript" }));

export class EngineWorker {
  constructor() {
    this.waiting = new Map();
    this.count = 0;
    this.onEvent = () => {};
    this.open();
  }

  open() {
    const url = address();
    this.worker = new Worker(url);
    this.worker.onmessage = ({ data }) => this.receive(data);
    this.worker.onerror = (event) => this.fail(event.message || "the worker stopped");
    this.ready = wasmBytes().then((wasm) => this.send("load", [wasm]));
    this.ready.catch(() => {});
    this.ready.finally(() => URL.revokeObjectURL(url)).catch(() => {});
  }

  receive(data) {
    if (data.event) return this.onEvent(data);
    const { resolve, reject } = this.waiting.get(data.id);
    this.waiting.delete(data.id);
    if ("error" in data) reject(new Error(data.error));
    else resolve(data.result);
  }

  fail(message) {
    for (const { reject } of this.waiting.values()) reject(new Error(message));
    this.waiting.clear();
    this.onEvent({ event: "failed", message });
  }

  send(method, values) {
    return new Promise((resolve, reject) => {
      const id = ++this.count;
      this.waiting.set(id, { resolve, reject });
      this.worker.postMessage({ id, method, values });
    });
  }

  /// Calls a method of the engine.
  async call(method, ...values) {
    await this.ready;
    return this.send(method, values);
  }

  async order(order, values = {}) {
    await this.ready;
    this.worker.postMessage({ order, ...values });
  }

  /// Replaces the worker by a fresh one.
  renew() {
    this.close();
    this.open();
  }

  close() {
    this.worker.terminate();
    for (const { reject } of this.waiting.values()) reject(new Error("closed"));
    this.waiting.clear();
  }
}

/// Workers that compute replicates. They are started when they are first needed, and kept.
export class Pool {
  constructor(most = Math.min(Math.max((navigator.hardwareConcurrency ?? 2) - 1, 1), 8)) {
    this.most = most;
    this.workers = [];
  }

  take(count) {
    while (this.workers.length < Math.min(count, this.most)) this.workers.push(new EngineWorker());
    return this.workers.slice(0, count);
  }
}
