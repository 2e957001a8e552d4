// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Runs of one case at several values of one key, one after another.

import { Run } from "./run.js";

export class Sweep {
  /// `points`: list of { number, value, set }, where `value` is the text for the key; or `set` lists keys and values. `listener(sweep)` is
  /// called after each step.
  constructor(pool, inspector, { toml, key, points, replicates }, listener) {
    Object.assign(this, { pool, inspector, toml, key, points, replicates, listener });
    this.status = "computing";
    this.at = 0;
  }

  async start() {
    for (this.at = 0; this.at < this.points.length; ++this.at) {
      if (this.status !== "computing") return;
      await this.runPoint(this.points[this.at]);
      this.listener(this);
    }
    if (this.status === "computing") this.status = "done";
    this.listener(this);
  }

  async runPoint(point) {
    const set = point.set ?? [[this.key, String(point.value)]];
    const { faults } = await this.inspector.call("check", this.toml, set);
    if (faults.length > 0) {
      point.fault = faults[0].text;
      return;
    }
    this.run = new Run(this.pool, this.inspector, { toml: this.toml, set, film: false,
      pictures: false, replicates: this.replicates }, { progress: () => this.listener(this) });
    await this.run.start();
    if (this.run.status === "failed") point.fault = this.run.message;
    else if (this.run.status === "done") point.summary = this.run.summary;
  }

  share() {
    const part = this.run && this.status === "computing" ? this.run.share() : 0;
    return Math.min((this.at + part) / this.points.length, 1);
  }

  stop() {
    if (this.status !== "computing") return;
    this.status = "stopped";
    this.run?.stop();
    this.listener(this);
  }
}
