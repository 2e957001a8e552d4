// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// match: finds settings of one mill that reproduce the dose and spectrum of another mill.
#include "mahlwerk/campaign/search/match.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/searches/searching.hpp"
#include "mahlwerk/report/match.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/study_json.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

/// The target is the case of mill A.
struct MatchArguments : CaseArguments {
  std::string in;                    ///< mill B
  std::optional<double> checkpoint;  ///< [s]
};

/// Mill B, whose settings are searched, and its target, mill A.
struct MatchJob {
  cases::Case like;                           ///< A
  const campaign::TrialRuns* runs = nullptr;  ///< of B
  bool by_powder = false;
  campaign::MillSpectra spectra;  ///< of A
};

bool has_powder(const cases::Case& mill_case) {
  return mill_case.powder && mill_case.powder->mass > 0;
}

/// The case without collision and frame output: only such runs can resume from a checkpoint.
cases::Case without_streams(cases::Case mill_case) {
  mill_case.observe.collisions = false;
  mill_case.observe.frames = {};
  return mill_case;
}

/// Runs one case to its end. Throws Interrupted, or RunError if a replicate stops early.
results::Outcome whole(const MatchArguments& given, const cases::Case& mill_case, const char* name,
                       const results::Folder& folder, campaign::ResumableRuns& kept) {
  campaign::Streams none(version());
  none.add(mill_case, folder, "");
  const results::Outcome outcome =
      compute(given.running, {mill_case}, none, kept, given.checkpoint).front();
  if (stop_wanted()) throw Interrupted();
  for (const results::Replicate& r : outcome.replicates)
    if (!r.stop_reason.empty()) throw RunError(fmt::format("mill {}: {}", name, r.stop_reason));
  return outcome;
}

cases::Case read_like(const fs::path& file, const cases::Catalogue& known) {
  cases::Case like = cases::read(file, known);
  if (!like.sweep.empty())
    throw InputError(Fault{like.file, "the case has a [sweep], match takes a single case",
                           "remove the section [sweep]", "one-case"});
  if (auto wrong = campaign::run_faults(like); !wrong.empty()) throw InputError(std::move(wrong));
  return like;
}

campaign::SearchJob search_job(const MatchJob& job) {
  const cases::Match& wanted = *job.runs->base().match;
  campaign::SearchJob made{
      .runs = job.runs,
      .goal = campaign::goal_of(*job.runs, wanted.settings, wanted.replicates),
      .outcomes = {{"distance", "1", "of dose and spectrum from those of the other mill"}},
      .limits = {},
      .measure = {}};
  made.measure = [&job](const results::Outcome& outcome, const results::Replicate& replicate) {
    const campaign::DoseSpectrum one =
        campaign::dose_spectrum(outcome.mill_case, replicate, job.by_powder);
    return std::vector<double>{campaign::distance(job.spectra.mean, one)};
  };
  return made;
}

void print_summary(const campaign::MatchResult& found, const fs::path& place, bool written) {
  Places paths{
      {"results", place}, {"report", place / "match.html"}, {"settings", place / "settings.csv"}};
  if (found.search.best) paths.emplace_back("case", place / "best.toml");
  print_found(
      fmt::format("A: {}\nB: {}\n\n{}", found.title_a, found.title_b, report::match_table(found)),
      paths, written);
}

/// Searches the settings of B, runs B at the best setting with new seeds, and writes the results of
/// both mills. `unwritten` takes why they cannot be written.
campaign::MatchResult find(const MatchArguments& given, MatchJob& job,
                           const results::Folder& folder, ResumableSearch& kept,
                           std::vector<Fault>& unwritten) {
  constexpr int anew = 1'000'000;  // first replicate, beyond those that the search uses
  const cases::Case& base = job.runs->base();
  const results::Outcome a = whole(given, job.like, "A", folder, kept.runs());
  job.spectra = campaign::mill_spectra(a, job.by_powder);
  if (job.spectra.replicates.empty())
    throw RunError("mill A has no collisions: there is nothing to match");
  campaign::SearchJob search = search_job(job);
  search.measure_name =
      fmt::format("like {} by {}", campaign::hash_text(campaign::run_hash(job.like, version())),
                  job.by_powder ? "powder" : "mill");
  campaign::MatchResult made{.title_a = a.mill_case.title,
                             .title_b = base.title,
                             .file_a = a.mill_case.file,
                             .file_b = base.file,
                             .a = job.spectra,
                             .search = run_search(given.running, search, kept)};
  const campaign::Optimum& found = made.search;
  made.search.check = check_best(given.running, search, found, kept);
  results::count(made.notices, a.notices);
  unwritten = write_result([&] { report::write(folder, a, version(), "a/"); });
  if (!found.best) return made;
  const campaign::DesignPoint& point = found.trials[*found.best].point;
  const int count = static_cast<int>(base.match->replicates);
  const results::Outcome b =
      whole(given, without_streams(job.runs->at(point, anew, count)), "B", folder, kept.runs());
  made.by_powder = job.by_powder;
  made.b = campaign::mill_spectra(b, job.by_powder);
  made.difference = campaign::difference(made.a, made.b, base.seed);
  results::count(made.notices, b.notices);
  results::sort(made.notices);
  if (unwritten.empty())
    unwritten = write_result([&] {
      report::write(folder, b, version(), "b/");
      results::write_case(folder, job.runs->at(point, 0, static_cast<int>(base.run.replicates)),
                          "best.toml");
    });
  return made;
}

int match(const MatchArguments& given) {
  const Running& running = given.running;
  const cases::Catalogue known = catalogue();
  const std::vector<cases::Override> set = given.changes.overrides();
  const fs::path file_a = one_case_file(given.target, "match");
  const fs::path file_b = one_case_file(given.in, "match");
  const cases::Case mill_case = cases::read(file_b, known, set);
  if (!mill_case.match)
    throw InputError(Fault{mill_case.file, "the case has no [match]",
                           "name the keys to vary: [match] with over = { \"mill.speed\" = "
                           "{ from = \"200 rpm\", to = \"600 rpm\" } }",
                           "nothing-to-match"});
  campaign::check_keys(mill_case, mill_case.match->over, "[match]");
  const campaign::TrialRuns runs(file_b, known, set, cases::ValueSource::match);
  MatchJob job{.like = without_streams(read_like(file_a, known)),
               .runs = &runs,
               .by_powder = false,
               .spectra = {}};
  job.by_powder = has_powder(job.like) && has_powder(mill_case);
  job.like.run.replicates = std::max(job.like.run.replicates, mill_case.match->replicates);
  const fs::path usual = default_folder(given.in, file_b, false).string() + "-match";
  catch_ctrl_c();
  results::Folder folder(running.out.value_or(usual), running.force);
  folder.reserve();
  ResumableSearch kept(folder.target());
  try {
    std::vector<Fault> unwritten;
    const campaign::MatchResult found = find(given, job, folder, kept, unwritten);
    if (unwritten.empty())
      unwritten = write_result([&] {
        folder.write("match.json", report::match_json(found, version()).text(2) + '\n');
        folder.write("settings.csv", report::optimum_csv(found.search));
        folder.write("match.html", report::match_page(found, version()));
        folder.commit();
      });
    if (unwritten.empty()) kept.remove();
    const auto print = [&] {
      if (running.json) json_to_stdout(report::match_json(found, version()));
      if (running.prints_text()) print_summary(found, folder.target(), unwritten.empty());
    };
    return print_result(print, unwritten, found.search.best ? success : stopped_by_physics);
  } catch (const Interrupted&) {
    return kept.report_interrupted();
  }
}

}  // namespace

Command match_command() {
  const auto given = std::make_shared<MatchArguments>();
  return {"match", "find settings of one mill that reproduce what another mill does to the powder",
          joined({{{.name = "CASE",
                    .target = &given->target,
                    .about = "mill A, the target: a case file or folder",
                    .required = true},
                   {.name = "--in",
                    .target = &given->in,
                    .about = "mill B, whose settings are searched: a case with [match]",
                    .type = "CASE",
                    .required = true}},
                  options_of(given->changes),
                  options_of(given->running, " of mill B, with -match"),
                  {resumable_checkpoint(given->checkpoint), json(given->running.json)}}),
          [given] { return match(*given); }};
}

}  // namespace mahlwerk::commands
