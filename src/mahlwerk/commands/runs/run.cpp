// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// run: runs one case, or every case of a folder, into result folders; cases with [sweep] as
// campaigns.
#include "mahlwerk/campaign/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/forecast.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/campaigns/sweep_case.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/runs/lammps.hpp"
#include "mahlwerk/commands/runs/run_jobs.hpp"
#include "mahlwerk/commands/runs/wear_evolution.hpp"
#include "mahlwerk/report/key_numbers.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/states.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

/// A line that lists uncalibrated default values of the case; empty if there are none.
std::string uncalibrated(const cases::Case& mill_case) {
  std::string line;
  for (const cases::Origin& origin : mill_case.origins)
    if (origin.assumed && origin.source.find("uncalibrated") != std::string::npos)
      line += fmt::format("{}{} = {}", line.empty() ? "" : ", ", origin.key, origin.value);
  return line.empty() ? "" : "assumed, not calibrated: " + line + "\n\n";
}

void print_summary(const RunJob& job, const results::Outcome& outcome, bool written) {
  title_to_stdout(job.mill_case.title);
  to_stdout(fmt::format("\n{}\n", report::key_table(outcome)));
  to_stdout(report::states_table(outcome));
  to_stdout(fmt::format(
      "{}\n", report::table(outcome.summary.quantities, job.mill_case.observe.threshold)));
  const std::string pairs =
      report::pair_table(outcome.summary.pairs, job.mill_case.observe.threshold);
  if (!pairs.empty()) to_stdout(fmt::format("{}\n", pairs));
  if (const std::string& regime = outcome.summary.regime; !regime.empty())
    to_stdout(fmt::format("{}: {}\n\n", regime, outcome.summary.regime_reason));
  to_stdout(fmt::format("{}", uncalibrated(job.mill_case)));
  for (const Notice& one : outcome.notices)
    to_stdout(fmt::format("{}{}\n\n", one.warns() ? "Warning: " : "", one.text));
  if (!written) return;
  places_to_stdout({{"results", job.place},
                    {"report", job.place / "report.html"},
                    {"numbers", job.place / "summary.json"}});
  to_stdout("\n");
}

/// The places of the results; the results themselves where they could not be written.
void print_json(const std::vector<RunJob>& jobs, const std::vector<results::Outcome>& outcomes,
                const std::vector<bool>& written) {
  results::Json list = results::Json::array();
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    results::Json one = results::Json::object({{"title", jobs[i].mill_case.title}});
    if (written[i])
      one["results"] = jobs[i].place.string();
    else
      one["summary"] = results::summary_of(outcomes[i], version());
    list.push_back(std::move(one));
  }
  json_to_stdout(list);
}

/// [s] How long a run takes before it keeps checkpoints unasked.
double unasked_after() {
  constexpr double usual = 60;
  const char* said = std::getenv("MAHLWERK_CHECKPOINT_AFTER");
  const NumberText wanted = number_text(said != nullptr ? said : "");
  return wanted.number >= 0 ? wanted.number : usual;
}

/// Warns of the checkpoint of an earlier run, which this run would replace.
void warn_of_checkpoint(const fs::path& file) {
  std::error_code none;
  if (fs::exists(file, none))
    print_warning({file.string(), "there is a checkpoint of an ended run, which this run replaces",
                   "to continue that run, end this one within a minute, and start it with --resume",
                   "checkpoint-replaced"});
}

/// The checkpoint file beside the results; nullptr if none is kept.
std::unique_ptr<campaign::Checkpoint> checkpoint(const RunArguments& given,
                                                 const std::vector<RunJob>& jobs) {
  if (given.no_checkpoint || jobs.front().mill_case.run.engine == cases::EngineName::lammps)
    return nullptr;
  const bool asked = given.checkpoint || given.lammps.resume;
  std::string what = fmt::format("version {}\n", version());
  std::size_t replicates = 0;
  for (const RunJob& job : jobs) {
    const bool streams = job.mill_case.observe.collisions || job.mill_case.observe.frames;
    if (streams && !asked) return nullptr;
    if (streams)
      throw InputError(Fault{
          job.mill_case.file,
          fmt::format("a run that keeps {} cannot be resumed",
                      job.mill_case.observe.frames ? "frames" : "every collision"),
          fmt::format("{}, or omit --checkpoint and --resume", job.mill_case.observe.frames
                                                                   ? "omit [observe] frames"
                                                                   : "write collisions = false"),
          "bad-checkpoint"});
    cases::Case on_any = job.mill_case;  // a run may go on where another device left it
    on_any.run.device = cases::DeviceName::automatic;
    what += cases::write(on_any) + cases::input_files_fingerprint(job.mill_case);
    replicates += static_cast<std::size_t>(job.mill_case.run.replicates);
  }
  fs::path place = jobs.front().place;
  if (jobs.size() > 1) place = place.parent_path();
  const fs::path file = place.string() + ".checkpoint";
  constexpr double usual = 60;  // [s]
  if (!given.lammps.resume) warn_of_checkpoint(file);
  std::optional<campaign::Checkpoint::Unasked> unasked;
  if (!asked) unasked = {.after = unasked_after()};
  auto made = std::make_unique<campaign::Checkpoint>(
      file, what, replicates,
      given.checkpoint.value_or(unasked ? std::min(usual, unasked->after) : usual), print_warning,
      unasked);
  if (given.lammps.resume) made->load();
  return made;
}

/// How an interrupted run can be continued; empty if it cannot.
std::string continuation(const campaign::Checkpoint* kept, bool by_lammps) {
  if (by_lammps) return "; the same command with --resume continues the run";
  if (kept == nullptr || !kept->written()) return "";
  return fmt::format("; the same command with --resume continues the run from {}",
                     kept->file().string());
}

/// What the assumed values of a single run decide. Returns whether that was interrupted.
bool add_sensitivity(const RunArguments& given, const RunJob& job, results::Outcome& outcome) {
  const cases::Catalogue known = catalogue();
  const auto read = [&](const std::string& key, const std::string& text) {
    std::vector<cases::Override> set = given.overrides();
    set.push_back({key, text});
    return job.source.read(known, set);
  };
  ProgressLine line(given.running.quiet);
  campaign::RunOptions options = run_options(given.running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  options.lammps.ranks = given.lammps.ranks;
  const bool stopped_before = stop_wanted();
  if (!stopped_before) line.show("varying the assumed values");
  outcome.summary.sensitivity = campaign::sensitivity_to_assumed(outcome, read, options);
  return !stopped_before && stop_wanted() && !outcome.summary.sensitivity;
}

/// Writes the results of all jobs into their folders. Returns which were written; `unwritten` takes
/// why the others were not.
std::vector<bool> write_all(const std::vector<RunJob>& jobs,
                            const std::vector<results::Outcome>& outcomes,
                            std::vector<Fault>& unwritten) {
  std::vector<bool> written;
  for (std::size_t i = 0; i < jobs.size(); ++i) {
    const std::vector<Fault> faults = write_result([&] {
      report::write(*jobs[i].folder, outcomes[i], version());
      jobs[i].folder->commit();
    });
    written.push_back(faults.empty());
    unwritten.insert(unwritten.end(), faults.begin(), faults.end());
  }
  return written;
}

void print_results(const Running& running, const std::vector<RunJob>& jobs,
                   const std::vector<results::Outcome>& outcomes,
                   const std::vector<bool>& written) {
  const bool talks = running.prints_text();
  for (std::size_t i = 0; talks && i < jobs.size(); ++i)
    print_summary(jobs[i], outcomes[i], written[i]);
  if (running.json) print_json(jobs, outcomes, written);
  if (talks) fmt::print("computed in {} s\n", two_digits(outcomes.front().wall_seconds));
}

/// Runs all cases without [sweep] together.
int run_cases(const RunArguments& given, const std::vector<RunJob>& jobs) {
  const auto kept = checkpoint(given, jobs);
  const bool by_lammps = jobs.front().mill_case.run.engine == cases::EngineName::lammps;
  WriteErrorReporter not_recorded;
  campaign::Streams streams(version(), std::ref(not_recorded));
  for (const RunJob& job : jobs) streams.add(job.mill_case, *job.folder, "");
  std::vector<results::Outcome> outcomes = compute(
      given.running, cases_of(jobs), streams, kept.get(),
      {.folder = lammps_root(jobs), .ranks = given.lammps.ranks, .resume = given.lammps.resume});
  std::vector<Fault> unwritten = write_result([&] { streams.close(); });
  const bool varying = jobs.size() == 1 && add_sensitivity(given, jobs.front(), outcomes.front());
  // All files before any output, which may fail.
  const std::vector<bool> written = write_all(jobs, outcomes, unwritten);
  const bool whole = std::ranges::all_of(outcomes, results::complete),
             asked = given.checkpoint || given.lammps.resume;
  if (kept && unwritten.empty() && (whole || !(asked || stop_wanted()))) kept->remove();
  const std::string how = continuation(kept.get(), by_lammps);
  if (!unwritten.empty()) unwritten.front().remedy += how;
  const int printed = print_result([&] { print_results(given.running, jobs, outcomes, written); },
                                   unwritten, success);
  if (!unwritten.empty()) return printed;
  const int ended =
      report_exit_status(outcomes, varying ? "; what assumed values decide was not computed"
                                   : whole ? ""
                                           : how);
  if (kept && kept->write_error()) print_warning(*kept->write_error());
  return ended;
}

int run(const RunArguments& given) {
  catch_ctrl_c();
  std::vector<RunJob> plain, campaigns, evolving;
  for (RunJob& job : prepare_all(given))
    (job.sweeps() ? campaigns : job.evolves() ? evolving : plain).push_back(std::move(job));
  if (given.lammps.writes_only())
    return write_for_lammps(given.lammps, given.running, cases_of(plain), lammps_root(plain));
  int worst = plain.empty() ? success : run_cases(given, plain);
  for (const RunJob& job : campaigns) {
    if (worst == interrupted) break;
    worst =
        std::max<int>(worst, sweep_case(given.running, {}, job.file, given.overrides(), job.place));
  }
  for (const RunJob& job : evolving) {
    if (worst == interrupted) break;
    worst = std::max<int>(worst, evolve_wear(given.running, job));
  }
  return worst;
}

}  // namespace

Command run_command() {
  const auto given = std::make_shared<RunArguments>();
  return {
      "run", "run a case, or every case of a folder, and write its results",
      joined({{several_cases(given->target)},
              options_of(given->changes),
              options_of(given->running),
              lammps_options(given->lammps),
              {checkpoint(given->checkpoint,
                          "seconds between two checkpoints, kept beside the results, from "
                          "which --resume continues"),
               {"--no-checkpoint", &given->no_checkpoint,
                "keep no checkpoint; without it a run keeps one after a minute"},
               {"--resume", &given->lammps.resume, "resume an ended run from its last checkpoint"},
               json(given->running.json)}}),
      [given] { return run(*given); }};
}

}  // namespace mahlwerk::commands
