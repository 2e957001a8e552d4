// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Firefox, driven by its own protocol Marionette: messages of JSON with their length before them.

import { spawn } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { connect } from "node:net";
import { tmpdir } from "node:os";
import { join } from "node:path";

const pause = (milliseconds) => new Promise((resolve) => setTimeout(resolve, milliseconds));

const preferences = {
  "marionette.port": 0, // a free one, which Firefox writes into its profile
  "app.update.enabled": false, "datareporting.policy.dataSubmissionEnabled": false,
  "toolkit.telemetry.enabled": false, "browser.shell.checkDefaultBrowser": false,
  "services.settings.server": "data:,", // no requests of its own
  "webgl.force-enabled": true, // also without a graphics card
};

async function portOf(profile) {
  for (let i = 0; i < 300; ++i, await pause(100))
    try {
      return Number(readFileSync(join(profile, "MarionetteActivePort"), "utf8"));
    } catch { /* not yet written */ }
  throw new Error("Firefox does not start");
}

export class Firefox {
  static async start(program) {
    const profile = mkdtempSync(join(tmpdir(), "mahlwerk-firefox-"));
    const lines = Object.entries(preferences).map((pair) => `user_pref(${pair.map(JSON.stringify).join(", ")});\n`);
    writeFileSync(join(profile, "user.js"), lines.join(""));
    const process = spawn(program, ["--headless", "--no-remote", "--profile", profile, "--marionette",
      "--remote-allow-system-access"], { stdio: "ignore" });
    const firefox = new Firefox();
    Object.assign(firefox, { profile, process, waiting: new Map(), count: 0, rest: Buffer.alloc(0) });
    firefox.socket = connect(await portOf(profile), "127.0.0.1");
    firefox.socket.on("data", (bytes) => firefox.receive(bytes));
    firefox.version = (await firefox.call("WebDriver:NewSession", {})).capabilities.browserVersion;
    return firefox;
  }

  receive(bytes) {
    this.rest = Buffer.concat([this.rest, bytes]);
    for (;;) {
      const colon = this.rest.indexOf(":");
      const end = colon + 1 + Number(this.rest.subarray(0, colon));
      if (colon < 0 || this.rest.length < end) return;
      this.answer(JSON.parse(this.rest.subarray(colon + 1, end)));
      this.rest = this.rest.subarray(end);
    }
  }

  /// The first message greets; the others are [1, number, error, result].
  answer(message) {
    if (!Array.isArray(message)) return;
    const [, number, error, result] = message;
    const { resolve, reject } = this.waiting.get(number);
    if (error) reject(new Error(`${error.error}: ${error.message}`));
    else resolve(result);
  }

  call(command, values) {
    return new Promise((resolve, reject) => {
      const text = JSON.stringify([0, ++this.count, command, values]);
      this.waiting.set(this.count, { resolve, reject });
      this.socket.write(`${Buffer.byteLength(text)}:${text}`);
    });
  }

  /// The value of a script's `return`. `context`: "content" is the page, "chrome" the browser.
  async run(script, context = "content", args = []) {
    await this.call("Marionette:SetContext", { value: context });
    const { value } = await this.call("WebDriver:ExecuteScript", { script, args, newSandbox: false });
    await this.call("Marionette:SetContext", { value: "content" });
    return value;
  }

  open(url) {
    return this.call("WebDriver:Navigate", { url });
  }

  /// Waits until the script returns something true.
  async until(script, seconds = 60) {
    for (const end = Date.now() + 1000 * seconds; Date.now() < end; await pause(50))
      if (await this.run(script)) return;
    throw new Error(`not within ${seconds} s: ${script}`);
  }

  async end() {
    await this.call("Marionette:Quit", { flags: ["eForceQuit"] }).catch(() => {});
    this.socket.destroy();
    await new Promise((resolve) => (this.process.exitCode === null ? this.process.once("exit", resolve) : resolve()));
    rmSync(this.profile, { recursive: true, force: true });
  }
}
