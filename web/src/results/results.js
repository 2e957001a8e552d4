// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Everything that is shown of a result, while it is computed and afterwards.

import { HistoryPanel } from "../history/history_panel.js";
import { text } from "../text/text.js";
import { About } from "./about.js";
import { Comparison } from "./comparison.js";
import { Counters } from "./counters.js";
import { Files } from "./files.js";
import { NoticeBox } from "./notices.js";
import { Quantities } from "./quantities.js";
import { ReplayPanel } from "./replay_panel.js";
import { ReportPanel } from "./report_panel.js";
import { SeriesPlot } from "./series_plot.js";
import { SpectrumPlot } from "./spectrum_plot.js";

export class Results {
  /// `actions`: download (the case), caseText, restore (a case), open (files), openEntry(id) of the history.
  constructor({ title, counters, notices, replay, plots, tabs }, history, actions) {
    const { panels } = tabs;
    this.title = title;
    this.tabs = tabs;
    this.counters = new Counters(counters);
    this.notices = new NoticeBox(notices, () => this.openAbout());
    this.replay = new ReplayPanel(replay);
    this.spectrum = new SpectrumPlot();
    this.series = new SeriesPlot();
    plots.append(this.spectrum.root, this.series.root);
    this.quantities = new Quantities(panels.quantities);
    this.comparison = new Comparison(panels.comparison, { keep: () => this.finished, changed: () => this.redraw(),
      restore: actions.restore, history });
    this.history = new HistoryPanel(panels.history, history, { open: actions.openEntry,
      caseNow: () => this.caseNow(actions.caseText()), compare: (side, id) => this.comparison.choose(side, id),
      compared: () => this.comparison.chosen(), removed: (id) => this.comparison.removed(id) });
    this.report = new ReportPanel(panels.report);
    this.about = new About(panels.about, actions.download);
    this.files = new Files(panels.files, actions);
    this.counters.show(null);
    this.finished = null;
  }

  /// The case before it runs. `fresh`: it is another case, not a changed value.
  showCase(checked, fresh) {
    this.history.suggest(checked.title);
    this.replay.show(checked.film, fresh);
    this.unseen ||= fresh;
    this.title.textContent = checked.title;
    if (fresh) {
      this.counters.show(null);
      this.notices.show([]);
      this.quantities.show(null, false);
      this.spectrum.show(null);
      this.series.show(null);
      this.report.show(null);
      this.files.show(null);
      this.finished = null;
    }
    this.showAbout(checked, checked.notices);
    if (fresh) this.comparison.draw();
  }

  showAbout(checked, notices) {
    this.about.show(checked, notices);
    const warnings = notices.filter(({ severity }) => severity !== "note").length;
    this.tabs.badge("about", warnings > 0 ? String(warnings) : "", text.severity("warning"));
  }

  showStudy(html) {
    this.report.show(html);
    this.tabs.choose("report");
    this.tabs.list.scrollIntoView();
  }

  openAbout() {
    this.tabs.choose("about");
    this.tabs.panels.about.scrollIntoView({ block: "center" });
    this.tabs.buttons.find(({ id }) => id === "tab-about").focus({ preventScroll: true });
  }

  /// The case of the page, its name, and the entry of its result in the history if it has one.
  caseNow(toml) {
    const { finished } = this;
    return { toml, name: this.title.textContent, id: finished?.toml === toml ? finished.id : null };
  }

  begin(run) {
    this.history.suggest(run.checked.title);
    this.restart = this.unseen;
    this.unseen = false;
    this.finished = null;
    this.counters.show(run);
    this.notices.show([]);
    this.files.show(null);
    this.report.show(null);
    this.showAbout(run.checked, run.checked.notices);
    this.comparison.draw();
  }

  showProgress(run) {
    if (!run) return;
    this.counters.show(run);
    if (!run.summary) this.notices.showProgress(run);
  }

  showFilm(film) {
    if (!film) return;
    this.replay.show(film, this.restart);
    this.restart = false;
  }

  showPicture(run, film) {
    this.showFilm(film);
    this.quantities.show(run.quantities(), true);
    this.spectrum.show(run.spectrum(), this.comparison.kept?.spectrum);
    this.series.show(run.table("timeseries"));
  }

  /// `id`: its entry in the history.
  end(run, id) {
    this.replay.hurry();
    this.run = run;
    this.counters.show(run);
    if (run.status === "failed") return;
    const { summary, toml } = run;
    this.finished = { id, title: summary._about.title, toml, summary, spectrum: run.spectrum() };
    this.notices.show(summary._about.notices ?? []);
    this.showAbout(run.checked, summary._about.notices ?? []);
    this.files.show(run.files);
    this.report.show(run.files["report.html"] ?? null);
    this.comparison.draw();
    this.redraw();
  }

  redraw() {
    this.history.draw();
    if (!this.finished) return;
    this.quantities.show(this.finished.summary, false);
    const { kept } = this.comparison;
    const same = kept?.id === this.finished.id;
    this.spectrum.show(this.finished.spectrum, same ? null : kept?.spectrum);
    this.series.show(this.run.table("timeseries"));
  }
}
