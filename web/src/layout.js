// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The regions of the page.

import { button, choice, element } from "./dom.js";
import { isDark, onTheme, toggleTheme } from "./theme.js";
import { SharePanel } from "./share_panel.js";
import { languages, text } from "./text/text.js";
import { Tabs } from "./tabs.js";

const logo = () => element("img", { src: "icon.svg", alt: "", width: 30, height: 30 });

function header(actions) {
  const theme = button("", toggleTheme, { title: text.themeAbout, id: "theme" });
  const label = () => (theme.textContent = isDark() ? text.toLight : text.toDark);
  onTheme(label);
  label();
  const share = new SharePanel(actions.share);
  const language = choice(text.languageChoice, Object.values(languages).map(({ language: key, shortName, languageName }) =>
    ({ key, name: shortName, about: languageName })), text.language, actions.language);
  language.id = "language";
  for (const each of language.children) each.lang = each.dataset.key;
  const learn = button(text.learn, actions.learn, { title: text.learnAbout, id: "learn", "aria-expanded": "false" });
  return element("header", {}, element("div", { className: "inner" }, logo(),
    element("div", { className: "name" }, element("h1", { textContent: text.name }),
      element("p", { textContent: text.tagline })),
    element("div", { className: "buttons" }, language, learn, share.button, theme)), share.root);
}

function footer() {
  return element("footer", {}, element("p", {}, text.footer, " ", text.englishParts, " ",
    element("a", { href: "LICENSES.txt", textContent: text.licences }), " ",
    element("span", { id: "version" })));
}

function caseRegion() {
  const tabs = new Tabs(text.caseHeading, [{ key: "form", name: text.form },
    { key: "text", name: text.caseTab }]);
  const parts = { learn: element("section", { className: "learn", "aria-label": text.learn, hidden: true }),
    estimate: element("div"), examples: element("div", { className: "examples" }),
    form: element("form", { className: "form", onsubmit: (event) => event.preventDefault() }),
    faultLine: element("p", { className: "fault-line", role: "alert", hidden: true }),
    editor: element("div", { className: "text" }) };
  tabs.panels.form.append(parts.form);
  tabs.panels.text.append(parts.editor);
  const region = element("section", { className: "case", "aria-label": text.caseHeading },
    element("h2", { textContent: text.caseHeading }), parts.learn, parts.estimate, parts.examples, parts.faultLine, tabs.list,
    element("div", { className: "case-panels" }, tabs.panels.form, tabs.panels.text));
  return { region, caseTabs: tabs, ...parts };
}

function resultRegion() {
  const tabs = new Tabs(text.details, ["quantities", "report", "comparison", "history", "sweep", "about", "files"]
    .map((key) => ({ key, name: text[key] })));
  const parts = { title: element("h2", { className: "title" }),
    counters: element("dl", { className: "counters" }),
    stale: element("p", { className: "stale", hidden: true, textContent: text.changed }),
    notices: element("div", { className: "result-notices", role: "status", hidden: true }),
    replay: element("section", { id: "replay", "aria-label": text.replay }),
    plots: element("div", { className: "plots" }) };
  const region = element("section", { className: "result", id: "result", tabIndex: -1,
    "aria-label": text.resultHeading }, parts.title, parts.counters, parts.stale, parts.notices,
  parts.replay, parts.plots, element("div", { className: "details" }, tabs.list, Object.values(tabs.panels)));
  return { region, tabs, ...parts };
}

/// On narrow screens one of the regions is seen at a time.
export function showRegion(name) {
  document.body.dataset.region = name;
  document.querySelectorAll(".regions button").forEach((each) =>
    each.setAttribute("aria-pressed", String(each.dataset.key === name)));
}

/// Builds the page; returns its parts.
export function layOut(actions) {
  const given = caseRegion();
  const result = resultRegion();
  const runBar = element("div", { className: "run-bar", role: "group", "aria-label": text.runHeading });
  const regions = choice(text.regions, [{ key: "case", name: text.caseHeading },
    { key: "result", name: text.resultHeading }], "result", showRegion);
  regions.classList.add("regions");
  runBar.append(regions);
  document.title = `${text.name}: ${text.tagline}`;
  document.documentElement.lang = text.language;
  document.body.replaceChildren(
    element("a", { className: "skip", href: "#result", textContent: text.skip,
      onclick: (event) => {
        event.preventDefault();
        showRegion("result");
        result.region.focus();
      } }),
    header(actions), element("main", {}, given.region, runBar, result.region), footer());
  showRegion("result");
  const { region: caseBox, ...givenParts } = given;
  const { region: resultBox, ...resultParts } = result;
  return { caseBox, resultBox, runBar, ...givenParts, ...resultParts };
}
