// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The page: connects the case, the runs and what is shown of them.

import { button, copied, download, element, later } from "./dom.js";
import { CaseStore, kept } from "./case/store.js";
import { Editor } from "./case/editor.js";
import { EstimateForm } from "./case/estimate_form.js";
import { Form } from "./case/form.js";
import { fragmentOf } from "./case/share.js";
import { frameOf, isEmbedded } from "./embed.js";
import { ExampleChoice } from "./example_choice.js";
import { History } from "./history/history.js";
import { Learn } from "./learn/learn.js";
import { layOut, showRegion } from "./layout.js";
import { Results } from "./results/results.js";
import { SweepPanel } from "./results/sweep_panel.js";
import { Pool } from "./run/engine_worker.js";
import { OpenedRun, caseAmong, filesOf, filmOf, studyAmong } from "./run/opened_run.js";
import { Follow } from "./run/follow.js";
import { Run } from "./run/run.js";
import { RunBar } from "./run/run_bar.js";
import lessonCases from "lesson-cases";
import { chooseLanguage, text } from "./text/text.js";

export class Page {
  /// `inspector`: the worker that checks and merges. `cases`: texts of the examples.
  constructor(inspector, cases, known) {
    Object.assign(this, { inspector, cases });
    this.pool = new Pool();
    this.runs = 0; // that were started
    this.store = new CaseStore(inspector);
    this.parts = layOut({ share: () => this.share(), learn: () => this.learn.toggle(),
      language: (name) => (this.keep(), chooseLanguage(name)) });
    const { parts, store } = this;
    this.bar = new RunBar(parts.runBar, { run: () => this.start(), pause: () => this.pause(),
      stop: () => this.run?.stop() });
    this.follow = new Follow(this);
    this.bar.add(this.follow.root);
    this.estimateForm = new EstimateForm(parts.estimate, known, (words) => this.estimate(words));
    this.choice = new ExampleChoice(parts.examples, cases, (name) => this.chooseExample(name));
    this.form = new Form(parts.form, store, known);
    this.editor = new Editor(parts.editor, store);
    this.history = new History();
    this.results = new Results(parts, this.history, { download: () => this.downloadCase(), caseText: () => store.text,
      restore: (toml) => this.take(toml, ""), open: (items) => this.open(items), openEntry: (id) => this.openEntry(id) });
    if (!isEmbedded()) this.history.load(); // frames of other sites have no storage of their own
    this.sweep = new SweepPanel(parts.tabs.panels.sweep, { store, ...known, pool: this.pool, inspector,
      running: () => this.active() || this.sweeping, busy: (on) => this.busy(on) });
    this.learn = new Learn(parts.learn, lessonCases, this);
    this.keepSoon = later(() => this.keep(), 300);
    store.addEventListener("text", () => this.changed());
    addEventListener("pagehide", () => this.keep());
    addEventListener("popstate", ({ state }) => this.takeKept(state));
    store.addEventListener("checked", ({ detail }) => this.checked(detail));
    document.addEventListener("keydown", (event) => this.key(event));
    document.addEventListener("dragover", (event) => event.preventDefault());
    document.addEventListener("drop", (event) => {
      if (event.dataTransfer.files.length === 0) return; // a text, for the editor
      event.preventDefault();
      this.open(event.dataTransfer.items);
    });
    this.refreshSoon = later(() => this.refresh(), 0);
    this.showBar();
  }

  /// Shows a case that came with a link, which stays in the address until the case changes.
  takeLinked(toml) {
    this.linked = kept(toml);
    return this.take(toml, "");
  }

  /// Shows a case of an example (`name`) or another one (name ""). Resolves when it is checked.
  async take(toml, name) {
    if (this.active()) await this.stopped();
    this.run = null;
    this.note = "";
    this.fresh = true;
    this.choice.show(name);
    this.store.setText(toml, "choice");
    return this.store.check();
  }

  /// Whether the case is another than the example, the link or the estimate that it comes from.
  edited() {
    const { name } = this.choice;
    return this.store.text !== (name ? kept(this.cases[name]) : this.linked);
  }

  /// Whether an entry of the history keeps a case that no example has.
  edits(state) {
    return typeof state?.toml === "string" && state.toml !== kept(this.cases[state.name] ?? "");
  }

  /// Keeps the case with this entry of the history: a reload and Back find it there.
  keep() {
    if (this.store.text) history.replaceState({ toml: this.store.text, name: this.choice.name }, "", location.href);
  }

  /// Shows the case that an entry of the history keeps. Returns whether there is one.
  async takeKept(state) {
    if (typeof state?.toml !== "string") return false;
    if (/^#(case|lesson)=/.test(location.hash)) this.linked = state.toml;
    await this.take(state.toml, Object.hasOwn(this.cases, state.name) ? state.name : "");
    this.say(text.keptCase);
    return true;
  }

  /// Shows and runs an example, in an entry of the history of its own.
  chooseExample(name) {
    if (this.edited() && !confirm(text.leaveChanges)) return this.choice.show(this.choice.name);
    this.keep();
    history.pushState(null, "", "#");
    return this.runExample(name);
  }

  /// Makes and runs the case of an estimate, in an entry of the history of its own. Resolves with the faults of the
  /// words, and with the case whose lines they cite.
  async estimate(words) {
    let made;
    try {
      made = await this.inspector.call("estimate", words);
    } catch (error) {
      this.inspector.renew();
      return { faults: [{ where: "", line: 0, text: error.message, remedy: "", code: "internal" }], text: "" };
    }
    if (made.faults.length > 0 || (this.edited() && !confirm(text.leaveChanges))) return made;
    this.keep();
    history.pushState(null, "", "#");
    this.linked = kept(made.text);
    await this.take(made.text, "");
    this.start();
    return made;
  }

  async runExample(name) {
    await this.take(this.cases[name], name);
    return this.start();
  }

  /// Shows a result that the program computed, or takes a case: files, or a folder, that were dropped or chosen.
  /// The page of a campaign or a search stands beside the case, which stays.
  showStudy(html) {
    this.results.showStudy(html);
    showRegion("result");
    this.say(text.openedStudy);
  }

  async open(items) {
    try {
      const files = await filesOf(items);
      const toml = caseAmong(files), result = "summary.json" in files, study = studyAmong(files);
      if (!result && study !== null) return this.showStudy(study);
      if (!result && toml === null) return this.say(text.nothingToOpen);
      await this.show(toml ?? "", result ? files : null, text.openedCase);
    } catch (error) {
      this.say(text.cannotOpen(error.message));
    }
  }

  /// Shows a result, or takes a case, of the history.
  async openEntry(id) {
    await this.show(this.history.of(id).toml, await this.history.filesOf(id), text.openedEntry, id);
  }

  /// Shows a case and its result, or the case alone (files null) with a note, in an entry of the browser's history of
  /// its own. `id`: of the result in the history of the page, if it is there.
  async show(toml, files, note, id) {
    if (this.edited() && !confirm(text.leaveChanges)) return;
    this.keep();
    history.pushState(null, "", "#");
    this.linked = kept(toml);
    const checked = await this.take(toml, "");
    if (!files) return this.say(note);
    this.showOpened(new OpenedRun(files, this.store.text, checked.faults.length > 0 ? {} : checked), id);
  }

  showOpened(run, id) {
    this.run = run;
    this.results.begin(run);
    this.results.showFilm(filmOf(run.files["report.html"]));
    this.ended(run, id);
    this.say(text.opened(run.summary._about.title));
    showRegion("result");
  }

  stopped() {
    this.run.stop();
    return this.run.promise;
  }

  changed() {
    if (location.hash.startsWith("#case=") && this.store.text !== this.linked) history.replaceState(null, "", "#");
    this.keepSoon();
    this.showStale(this.follows());
    document.body.dataset.case = "unchecked";
    this.showBar();
    this.follow.changed();
  }

  checked(checked) {
    const { faults } = checked;
    document.body.dataset.case = faults.length > 0 ? "faulty" : "fine";
    const { faultLine, caseTabs } = this.parts;
    faultLine.hidden = faults.length === 0;
    caseTabs.badge("text", faults.length > 0 ? String(faults.length) : "");
    if (faults.length > 0)
      faultLine.replaceChildren(`${text.faultCount(faults.length)} ${faults[0].text} `,
        button(text.showFaults, () => {
          showRegion("case");
          caseTabs.choose("text");
          this.editor.goTo(faults[0]);
        }, { className: "quiet" }));
    this.showBar();
    const follows = this.follows();
    this.showStale(follows);
    if (faults.length > 0 || this.active() || follows) return;
    this.results.showCase(checked, this.fresh);
    this.fresh = false;
  }

  /// Whether the case, which has changed, is computed by itself (run/follow.js).
  follows() {
    const { checked, revision, text: toml } = this.store;
    const faulty = checked?.revision === revision && checked.faults.length > 0;
    return !faulty && this.follow.wanted() && this.run.toml !== toml;
  }

  /// Says that the result is not that of the case; not if it is computed anew anyway.
  showStale(follows) {
    this.parts.stale.hidden = follows || !this.run || this.run.toml === this.store.text;
  }

  active() {
    return this.run && ["computing", "paused", "stopping", "merging"].includes(this.run.status);
  }

  ready() {
    const { checked, revision } = this.store;
    return !this.sweeping && (checked?.revision !== revision || checked.faults.length === 0);
  }

  showBar() {
    this.bar.show(this.run, this.ready(), this.sweeping ? text.sweeping : this.note ?? "");
  }

  /// Computes the case as it is now. `stay`: the shown region of a narrow screen stays.
  async start(stay = false) {
    if (this.active() || this.sweeping) return null;
    const checked = await this.store.check();
    if (checked.faults.length > 0 || this.active() || this.sweeping) return null;
    this.note = "";
    this.parts.stale.hidden = true;
    this.run = new Run(this.pool, this.inspector,
      { toml: this.store.text, replicates: checked.replicates }, {
        progress: () => this.refreshSoon(),
        picture: (run, film) => this.results.showPicture(run, film),
        ended: (run) => this.ended(run),
      });
    this.run.checked = checked;
    document.body.dataset.runs = ++this.runs;
    this.results.begin(this.run);
    if (!stay) showRegion("result");
    this.run.start();
    this.refresh();
    return this.run.promise;
  }

  /// Computes the case in place of the run, whose picture stays until there is a new one.
  async restart() {
    const { run } = this;
    if (this.active()) await run.discard();
    if (this.run !== run) return null; // another case was chosen
    this.run = null;
    this.start(); // whose end nobody waits for: meanwhile the case may change again
    return null;
  }

  refresh() {
    this.showBar();
    this.results.showProgress(this.run);
  }

  /// `id`: of the result in the history, if it is there already.
  ended(run, id) {
    const entry = run.summary ? id ?? this.history.add(run.summary._about.title, run.toml, run.files) : null;
    this.results.end(run, entry);
    this.showStale(this.follows());
    this.showBar();
  }

  pause() {
    if (this.run?.status === "paused") this.run.resume();
    else this.run?.pause();
  }

  busy(on) {
    this.sweeping = on;
    this.showBar();
  }

  key(event) {
    if ((event.ctrlKey || event.metaKey) && event.key === "Enter") {
      event.preventDefault();
      this.start();
    }
  }

  /// Copies a link with the case. Resolves with what has been done, and the text of a frame with the case.
  async share() {
    const shared = this.store.text;
    const fragment = await fragmentOf(shared);
    this.linked = shared;
    history.replaceState(null, "", `#${fragment}`);
    const frame = frameOf(this.store.checked?.title ?? text.name, fragment);
    return { said: await copied(location.href) ? text.shared : text.sharedAddress, frame };
  }

  downloadCase() {
    download("case.toml", this.store.text, "application/toml");
  }

  say(note) {
    this.note = note;
    this.showBar();
  }

  showVersion(version) {
    document.getElementById("version").replaceChildren(element("span", {}, text.version(version)));
  }
}
