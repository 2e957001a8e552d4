// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The lessons beside the case: a list, and one lesson with its case, its question and its proof.

import { button, element, freshId } from "../dom.js";
import { kept } from "../case/store.js";
import { write } from "../case/toml_text.js";
import { showRegion } from "../layout.js";
import { text } from "../text/text.js";
import { LessonCheck } from "./lesson_check.js";
import { lessons } from "./lessons.js";
import { Progress } from "./progress.js";

/// Numbers stay on one line with their unit.
const tied = (words) => words.replace(/(\d) (?=(?:%|Hz|mm|mW|g|s)(?![a-z]))/g, "$1\u00a0");

export class Learn {
  /// `cases`: texts of web/lessons by name. `page`: the Page.
  constructor(root, cases, page) {
    Object.assign(this, { root, cases, page, number: 0, progress: new Progress() });
    this.list = element("ol", { className: "lesson-list" });
    this.about = element("p", { className: "note", textContent: text.learnIntro });
    this.lesson = element("div", { className: "lesson" });
    this.heading = element("h2", { textContent: text.learn, tabIndex: -1 });
    root.append(element("div", { className: "learn-head" }, this.heading,
      button("×", () => this.close(), { className: "quiet", title: text.learnClose, "aria-label": text.learnClose })),
    this.about, this.list, this.lesson);
  }

  toggle() {
    if (this.root.hidden) this.open(0);
    else this.close();
  }

  close() {
    this.check?.stop();
    this.root.hidden = true;
    this.number = 0;
    if (location.hash.startsWith("#lesson=")) history.replaceState(history.state, "", "#");
    this.showOpen(false);
  }

  /// Shows a lesson, or with 0 the list of all. `load`: shows and runs its case, too.
  async open(number, load = true) {
    await this.check?.stop();
    if (load && number > 0 && !(await this.takeCase(number))) return;
    this.number = number;
    this.root.hidden = false;
    this.showOpen(true);
    this.about.hidden = number > 0;
    this.showList();
    this.lesson.replaceChildren(...(number > 0 ? this.parts(number) : []));
    if (this.root.getBoundingClientRect().top < 0) this.root.scrollIntoView();
    (this.lesson.querySelector("h3") ?? this.heading).focus({ preventScroll: true });
  }

  /// While lessons are open, the estimate and the examples give way.
  showOpen(on) {
    document.body.toggleAttribute("data-learn", on);
    document.getElementById("learn").setAttribute("aria-expanded", String(on));
    if (on) showRegion("case");
  }

  /// Shows and runs the case of a lesson, in an entry of the history of its own. Resolves with whether it does: the
  /// reader may keep a changed case.
  async takeCase(number) {
    const { page } = this, address = `#lesson=${number}`;
    if (page.store.text && page.edited() && !confirm(text.leaveChanges)) return false;
    page.keep();
    if (location.hash !== address) history.pushState(null, "", address);
    await page.takeLinked(this.caseOf(number));
    page.start(true);
    return true;
  }

  /// Runs the case of a lesson with other values.
  runWith(toml) {
    this.page.linked = kept(toml);
    this.page.store.setText(toml, "form");
    return this.page.restart();
  }

  /// The case of a lesson, titled in the reader's language.
  caseOf(number, set = []) {
    return [["title", text.lessons[number - 1].title], ...set].reduce((toml, [key, value]) =>
      write(toml, key, /^[\d.]+$/.test(value) ? Number(value) : value), this.cases[lessons[number - 1].name]);
  }

  showList() {
    this.list.classList.toggle("small", this.number > 0);
    this.list.replaceChildren(...lessons.map(({ name }, i) => {
      const done = this.progress.has(name), { title } = text.lessons[i];
      const label = text.lessonName(i + 1, title) + (done ? ` (${text.lessonDone})` : "");
      return element("li", {}, element("button", { type: "button", title, "aria-label": label,
        "aria-current": i + 1 === this.number ? "true" : null, onclick: () => this.open(i + 1) },
      element("span", { className: done ? "number done" : "number", textContent: done ? "✓" : String(i + 1) }),
      element("span", { className: "title", textContent: title })));
    }));
  }

  parts(number) {
    const lesson = lessons[number - 1], words = text.lessons[number - 1];
    this.check = new LessonCheck({ lesson, words, toml: this.caseOf(number), page: this.page });
    return [element("h3", { textContent: words.title, tabIndex: -1 }), element("p", { textContent: tied(words.intro) }),
      element("p", { textContent: tied(words.task) }),
      element("div", { className: "chips", role: "group", "aria-label": `${text.lessonTry}: ${words.varied}` },
        element("span", { className: "note", textContent: words.varied }),
        lesson.points.map(({ value, set }) => button(value, () => this.runWith(this.caseOf(number, set))))),
      this.question(lesson, words), this.check.root,
      number < lessons.length ? button(text.lessonNext, () => this.open(number + 1)) : null].filter(Boolean);
  }

  question({ name, right }, words) {
    const group = freshId("answer");
    const said = element("p", { className: "feedback", role: "status", hidden: true });
    const answer = (i) => {
      said.replaceChildren(element("strong", {}, i === right ? text.lessonRight : text.lessonWrong), ` ${tied(words.answers[i][1])}`);
      said.hidden = false;
      said.classList.toggle("right", i === right);
      if (i !== right || this.progress.has(name)) return;
      this.progress.add(name);
      this.showList();
    };
    return element("fieldset", { className: "question" }, element("legend", { textContent: text.lessonQuestion }),
      element("p", { textContent: tied(words.question) }),
      words.answers.map(([told], i) => element("label", {},
        element("input", { type: "radio", name: group, onchange: () => answer(i) }), element("span", { textContent: tied(told) }))),
      said);
  }
}
