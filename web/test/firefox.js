// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page in Firefox: opens, runs, shows a result; no error, no foreign request; also from disk. Where
// Firefox has no WebGL 2, the page has to say so.
//
//   node test/firefox.js SITE
//
// Firefox is the variable FIREFOX, or Debian's firefox-esr. Exit code 77: it is not there.

import { existsSync } from "node:fs";
import { resolve } from "node:path";
import { pathToFileURL } from "node:url";
import { expect } from "./check.js";
import { Firefox } from "./marionette.js";
import { serve } from "./server.js";

const program = process.env.FIREFOX ?? "/usr/bin/firefox-esr";
if (!existsSync(program)) {
  console.log(`skipped: the page in Firefox; there is no ${program}`);
  process.exit(77);
}

/// For the browser: keeps the addresses of all requests that it does not make for itself.
const keepRequests = `
  const requests = Services.wm.getMostRecentWindow("navigator:browser").requestsOfTest = [];
  const keep = { observe: (channel) => {
    const { URI, loadInfo } = channel.QueryInterface(Ci.nsIHttpChannel);
    const itself = loadInfo.triggeringPrincipal.isSystemPrincipal &&
      loadInfo.externalContentPolicyType !== Ci.nsIContentPolicy.TYPE_DOCUMENT;
    if (!itself) requests.push(URI.spec);
  } };
  Services.obs.addObserver(keep, "http-on-modify-request");
  Services.console.reset();`;

/// For the browser: errors of pages since then, policy violations included.
const errors = `return Services.console.getMessageArray().filter((each) =>
  each instanceof Ci.nsIScriptError && !(each.flags & Ci.nsIScriptError.warningFlag) &&
  /^(http|file|blob)/.test(each.sourceName)).map((each) => each.message);`;

const done = 'return document.body?.dataset.run === "done"';
const press = (id) => `document.querySelector("${id}").click()`;

async function smoke(firefox, url, origin) {
  await firefox.run(keepRequests, "chrome");
  await firefox.open(url);
  await firefox.until(done);
  await firefox.until('return /drawn|no-webgl/.test(document.querySelector("#replay").dataset.state)');
  await firefox.run(`const area = document.querySelector("#case-text");
    area.value = area.value.replace('"10 Hz"', '"12 Hz"');
    area.dispatchEvent(new Event("input", { bubbles: true }));`);
  await firefox.until('return document.body.dataset.case === "fine"');
  await firefox.run(press("#run"));
  await firefox.until('return document.body.dataset.runs === "2" && document.body.dataset.run === "done"');
  const collisions = await firefox.run(
    'return document.querySelector(\'.counter[data-key="collisions"] .value\').textContent');
  expect("collisions", Number(collisions.replace(/\D/g, "")) > 0);
  await firefox.run(press("#tab-report"));
  await firefox.until('return document.querySelector("iframe") !== null');
  expect("errors", await firefox.run(errors, "chrome"), []);
  const requests = await firefox.run(
    'return Services.wm.getMostRecentWindow("navigator:browser").requestsOfTest', "chrome");
  expect("foreign requests", requests.filter((address) => !address.startsWith(origin)), []);
  const replay = await firefox.run('return document.querySelector("#replay").dataset.state');
  return `replay ${replay}, ${requests.length} requests`;
}

const site = resolve(process.argv[2]);
const server = await serve(site);
const disk = `${pathToFileURL(site)}/index.html`;
let failed = 0;
for (const [name, url, origin] of [["served", server.url, server.url], ["from disk", disk, "file:"]]) {
  const firefox = await Firefox.start(program);
  const begun = Date.now();
  try {
    const seen = await smoke(firefox, url, origin);
    console.log(`fine: Firefox ${firefox.version}, ${name}: ${seen}, ${((Date.now() - begun) / 1000).toFixed(1)} s`);
  } catch (error) {
    ++failed;
    console.log(`FAILED: Firefox ${firefox.version}, ${name}: ${error.message}`);
  }
  await firefox.end();
}
server.close();
process.exitCode = failed > 0 ? 1 : 0;
