// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The computation of one case: its replicates in workers, then the result merged from them.

import { parseCsv } from "../csv.js";
import { mergedSpectrum, mergedSummary } from "./merge.js";

const now = () => performance.now() / 1000;

export class Run {
  /// `pool`: workers for replicates. `inspector`: the worker that merges. `listener`: methods
  /// progress(run), picture(run, film), ended(run). `film`: whether a film is wanted while computing.
  constructor(pool, inspector, { toml, set = [], replicates, film = true, pictures = true }, listener) {
    Object.assign(this, { pool, inspector, toml, set, film, pictures, listener });
    this.status = "computing";
    this.replicates = Array.from({ length: replicates },
      (_, number) => ({ number, simulated: 0, total: 0, collisions: 0, state: null }));
    this.begun = now();
    this.paused = 0;
  }

  /// Computes everything. The promise is fulfilled with this run when it has ended.
  start() {
    this.queue = [...this.replicates];
    this.workers = this.pool.take(this.replicates.length);
    this.open = this.workers.length;
    return (this.promise = new Promise((resolve) => {
      this.finished = resolve;
      for (const worker of this.workers) this.next(worker);
    }));
  }

  next(worker) {
    const replicate = this.status === "stopping" ? null : this.queue.shift();
    if (!replicate) {
      worker.onEvent = () => {};
      if (--this.open === 0) this.finish();
      return;
    }
    worker.onEvent = (event) => this.take(worker, replicate, event);
    worker.order("compute", { toml: this.toml, set: this.set, replicate: replicate.number,
      pictures: this.pictures, film: this.film && replicate.number === 0 })
      .catch((error) => this.fail(worker, error.message));
    if (this.status === "paused") worker.order("pause");
  }

  take(worker, replicate, event) {
    if (event.event === "failed") return this.fail(worker, event.message);
    const { simulated, total, collisions } = event;
    if (event.event !== "picture") Object.assign(replicate, { simulated, total, collisions });
    if (event.event === "picture") {
      replicate.summary = event.summary;
      replicate.spectrum = parseCsv(event.spectrum);
      replicate.timeseries = event.timeseries;
      this.listener.picture?.(this, event.film);
    } else if (event.event === "ended") {
      replicate.state = event.state;
      replicate.reason = event.stop_reason;
      this.next(worker);
    }
    this.listener.progress?.(this);
  }

  /// A worker that failed is replaced; the run ends with the message.
  fail(worker, message) {
    if (this.status === "failed") return;
    this.status = "failed";
    this.message = message;
    for (const each of this.workers) {
      each.onEvent = () => {};
      each.renew();
    }
    this.end();
  }

  pause() {
    if (this.status !== "computing") return;
    this.status = "paused";
    this.pausedAt = now();
    this.workers.forEach((worker) => worker.order("pause"));
    this.listener.progress?.(this);
  }

  resume() {
    if (this.status !== "paused") return;
    this.status = "computing";
    this.paused += now() - this.pausedAt;
    this.workers.forEach((worker) => worker.order("resume"));
    this.listener.progress?.(this);
  }

  /// Ends the replicates that are being computed; the result holds what was simulated until then.
  stop() {
    if (this.status !== "computing" && this.status !== "paused") return;
    this.status = "stopping";
    this.stopped = true;
    this.queue = [];
    this.workers.forEach((worker) => worker.order("stop"));
    this.listener.progress?.(this);
  }

  /// Ends without a result, unless the replicates are already merged. Resolves when the workers are free.
  discard() {
    this.stop();
    this.discarded = this.status === "stopping";
    return this.promise;
  }

  async finish() {
    if (this.status === "failed") return;
    if (this.discarded) return this.finished(this);
    this.status = "merging";
    this.listener.progress?.(this);
    try {
      const states = this.replicates.map(({ state }) => state).filter(Boolean);
      const { faults, files } = await this.inspector.call("finish", this.toml, this.set, states);
      if (faults.length > 0) throw new Error(faults[0].text);
      this.files = {};
      for (const name of files) this.files[name] = await this.inspector.call("file", name);
      this.summary = JSON.parse(this.files["summary.json"]);
      this.status = this.stopped ? "stopped" : "done";
    } catch (error) {
      this.status = "failed";
      this.message = error.message;
    }
    for (const replicate of this.replicates) replicate.state = null;
    this.end();
  }

  end() {
    this.seconds = now() - this.begun - this.paused;
    this.listener.ended?.(this);
    this.finished(this);
  }

  sum(key) {
    return this.replicates.reduce((total, replicate) => total + (replicate[key] || 0), 0);
  }

  /// Whether the simulator stopped a replicate.
  endedEarly() {
    return this.replicates.some(({ reason }) => reason);
  }

  /// Share of the simulation that is computed, from 0 to 1.
  share() {
    const shares = this.replicates.map(({ simulated, total, state }) =>
      state || this.status === "done" ? 1 : total > 0 ? Math.min(simulated / total, 1) : 0);
    return shares.reduce((a, b) => a + b, 0) / shares.length;
  }

  /// Quantities so far, or of the finished result; null before the first picture.
  quantities() {
    if (this.summary) return this.summary;
    const summaries = this.replicates.map(({ summary }) => summary).filter(Boolean);
    return summaries.length > 0 ? mergedSummary(summaries) : null;
  }

  /// The spectrum as a table, or null.
  spectrum() {
    if (this.files?.["spectrum.csv"]) return parseCsv(this.files["spectrum.csv"]);
    const tables = this.replicates.map(({ spectrum }) => spectrum).filter((table) => table?.rows.length);
    return tables.length > 0 ? mergedSpectrum(tables) : null;
  }

  /// A table of the finished result or, while computing, the time series of the first replicate.
  table(name) {
    const finished = this.files?.[`${name}.csv`];
    if (finished) return parseCsv(finished);
    const text = name === "timeseries" ? this.replicates.find((r) => r.timeseries)?.timeseries : "";
    return text ? parseCsv(text) : null;
  }
}
