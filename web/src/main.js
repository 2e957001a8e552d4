// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Start of the page: the first worker, the case of the link or of the first example, the first run.

import "uplot/dist/uPlot.min.css";
import "../../viewer/src/replay.css";
import "./style/page.css";
import "./style/case.css";
import "./style/result.css";
import "./style/learn.css";
import "./style/plot.css";
import "./style/embed.css";
import { caseOf } from "./case/share.js";
import { knownOf } from "./case/known.js";
import { element } from "./dom.js";
import { embed, isEmbedded, runsAtOnce } from "./embed.js";
import { lessonOf } from "./learn/lessons.js";
import { Page } from "./page.js";
import { useWords } from "./format.js";
import { EngineWorker } from "./run/engine_worker.js";
import { text } from "./text/text.js";
import "./theme.js";
import cases from "example-cases";

useWords(text.numbers);

async function linked() {
  try {
    return { toml: await caseOf(location.hash) };
  } catch {
    return { toml: null, bad: true };
  }
}

/// Takes the case or the lesson of the address, or runs the first example.
async function begin(page, { toml, bad }) {
  const lesson = lessonOf(location.hash);
  const restored = page.edits(history.state) && (await page.takeKept(history.state));
  if (lesson > 0) return page.learn.open(lesson, !restored);
  if (restored) return;
  if (toml !== null) {
    await page.takeLinked(toml);
    if (runsAtOnce()) return page.start();
    page.say(text.fromLink);
    return;
  }
  const [first] = Object.keys(cases);
  const { name } = history.state ?? {}; // before a reload
  await page.runExample(Object.hasOwn(cases, name) ? name : first);
  if (bad) page.say(text.badLink);
}

async function start() {
  document.body.replaceChildren(element("p", { className: "loading", textContent: text.loading }));
  const inspector = new EngineWorker();
  let known;
  try {
    const { version } = await inspector.ready;
    known = { version, vocabulary: await inspector.call("vocabulary") };
  } catch (error) {
    document.body.replaceChildren(element("p", { className: "loading", role: "alert",
      textContent: text.loadFailed(error.message) }));
    return;
  }
  const page = new Page(inspector, cases, knownOf(known.vocabulary));
  page.showVersion(known.version);
  if (isEmbedded()) embed(page.parts.runBar);
  addEventListener("hashchange", async () => {
    const { toml, bad } = await linked(), lesson = lessonOf(location.hash);
    if (lesson > 0) return page.learn.open(lesson, !history.state); // Back and Forward bring their case
    if (page.learn.number > 0) page.learn.close();
    if (bad) page.say(text.badLinkLater);
    else if (toml !== null && toml !== page.store.text) await page.takeLinked(toml);
  });
  await begin(page, await linked());
}

if ("serviceWorker" in navigator && location.protocol.startsWith("http"))
  addEventListener("load", () => navigator.serviceWorker.register("sw.js").catch(() => {}));

start();
