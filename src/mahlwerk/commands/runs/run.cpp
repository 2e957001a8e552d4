// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// run: runs one case, or every case of a folder, into result folders; cases with [sweep] as
// campaigns.
#include "mahlwerk/campaign/run/run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>
#include <memory>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/assumed_values.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/campaigns/sweep_case.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/runs/lammps.hpp"
#include "mahlwerk/report/key_numbers.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/states.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct RunArguments : CaseArguments {
  LammpsArguments lammps;
  std::optional<double> checkpoint;  ///< [s] interval between two checkpoints

  std::vector<cases::Override> overrides() const {
    std::vector<cases::Override> all = changes.overrides();
    if (!lammps.engine.empty()) all.push_back({"run.engine", lammps.engine});
    return all;
  }
};

/// A case and its result folder.
struct RunJob {
  cases::Case mill_case;
  fs::path file, place;
  std::unique_ptr<results::Folder> folder;  ///< null for a campaign, which has its own folder

  bool sweeps() const { return !mill_case.sweep.empty(); }
};

RunJob prepare_run(const RunArguments& given, const fs::path& file, bool several,
                   const cases::Catalogue& catalogue) {
  RunJob job;
  job.file = file;
  job.mill_case = cases::read(file, catalogue, given.overrides());
  const auto& out = given.running.out;
  job.place = !out      ? default_folder(given.target, file, several)
              : several ? *out / file.stem()
                        : *out;
  if (job.sweeps()) return job;
  if (std::vector<Fault> wrong = campaign::run_faults(job.mill_case); !wrong.empty())
    throw InputError(std::move(wrong));
  if (!given.lammps.writes_only())
    job.folder =
        std::make_unique<results::Folder>(job.place, given.running.force || given.lammps.resume);
  return job;
}

/// A line that lists uncalibrated default values of the case; empty if there are none.
std::string uncalibrated(const cases::Case& mill_case) {
  std::string line;
  for (const cases::Origin& origin : mill_case.origins)
    if (origin.assumed && origin.source.find("uncalibrated") != std::string::npos)
      line += fmt::format("{}{} = {}", line.empty() ? "" : ", ", origin.key, origin.value);
  return line.empty() ? "" : "assumed, not calibrated: " + line + "\n\n";
}

void print_summary(const RunJob& job, const results::Outcome& outcome, bool written) {
  to_stdout(fmt::format("{}\n\n{}\n", job.mill_case.title, report::key_table(outcome)));
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
  fmt::print("results:  {}\n", job.place.string());
  fmt::print("report:   {}\n", (job.place / "report.html").string());
  fmt::print("numbers:  {}\n\n", (job.place / "summary.json").string());
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

/// The folder of all runs by LAMMPS, beside the results.
fs::path lammps_root(const std::vector<RunJob>& jobs) {
  const auto plain = std::ranges::count_if(jobs, [](const RunJob& job) { return !job.sweeps(); });
  fs::path place = jobs.front().place;
  if (!place.has_filename()) place = place.parent_path();  // "out/"
  if (plain > 1) place = place.parent_path();
  return place.string() + ".lammps";
}

std::vector<cases::Case> cases_of(const std::vector<RunJob>& jobs) {
  std::vector<cases::Case> found;
  for (const RunJob& job : jobs) found.push_back(job.mill_case);
  return found;
}

/// Reads all cases and checks all result folders before anything is computed. Throws InputError.
std::vector<RunJob> prepare_all(const RunArguments& given) {
  const cases::Catalogue known = catalogue();
  const std::vector<fs::path> files = case_files(given.target);
  std::vector<RunJob> jobs;
  std::vector<Fault> wrong;
  for (const fs::path& file : files) try {
      jobs.push_back(prepare_run(given, file, files.size() > 1, known));
    } catch (const InputError& e) {
      wrong.insert(wrong.end(), e.faults().begin(), e.faults().end());
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  check_lammps(given.lammps, given.running.force, cases_of(jobs), lammps_root(jobs));
  return jobs;
}

/// The checkpoint file beside the results; nullptr without --checkpoint and --resume.
std::unique_ptr<campaign::Checkpoint> checkpoint(const RunArguments& given,
                                                 const std::vector<RunJob>& jobs) {
  if (!given.checkpoint && !given.lammps.resume) return nullptr;
  if (jobs.front().mill_case.run.engine == cases::EngineName::lammps) return nullptr;
  std::string what = fmt::format("version {}\n", version());
  std::size_t replicates = 0;
  for (const RunJob& job : jobs) {
    if (job.mill_case.observe.collisions || job.mill_case.observe.frames)
      throw InputError(Fault{
          job.mill_case.file,
          fmt::format("a run that keeps {} cannot be resumed",
                      job.mill_case.observe.frames ? "frames" : "every collision"),
          fmt::format("{}, or omit --checkpoint and --resume", job.mill_case.observe.frames
                                                                   ? "omit [observe] frames"
                                                                   : "write collisions = false"),
          "bad-checkpoint"});
    what += cases::write(job.mill_case) + cases::input_files_fingerprint(job.mill_case);
    replicates += static_cast<std::size_t>(job.mill_case.run.replicates);
  }
  fs::path place = jobs.front().place;
  if (jobs.size() > 1) place = place.parent_path();
  constexpr double usual = 60;  // [s]
  auto made =
      std::make_unique<campaign::Checkpoint>(place.string() + ".checkpoint", what, replicates,
                                             given.checkpoint.value_or(usual), print_warning);
  if (given.lammps.resume) made->load();
  return made;
}

/// What the assumed values of a single run decide.
void add_sensitivity(const RunArguments& given, const RunJob& job, results::Outcome& outcome) {
  const cases::Catalogue known = catalogue();
  const auto read = [&](const std::string& key, const std::string& text) {
    std::vector<cases::Override> set = given.overrides();
    set.push_back({key, text});
    return cases::read(job.file, known, set);
  };
  ProgressLine line(given.running.quiet);
  campaign::RunOptions options = run_options(given.running.threads);
  options.progress = [&](const campaign::Progress& p) { line.show(p); };
  options.lammps.ranks = given.lammps.ranks;
  outcome.summary.sensitivity = campaign::sensitivity_to_assumed(outcome, read, options);
}

/// Runs all cases without [sweep] together.
int run_cases(const RunArguments& given, const std::vector<RunJob>& jobs) {
  const Running& running = given.running;
  const auto kept = checkpoint(given, jobs);
  std::vector<cases::Case> points;
  WriteErrorReporter not_recorded;
  campaign::Streams streams(version(), std::ref(not_recorded));
  for (const RunJob& job : jobs) {
    points.push_back(job.mill_case);
    streams.add(job.mill_case, *job.folder, "");
  }
  std::vector<results::Outcome> outcomes = compute(
      running, points, streams, kept.get(),
      {.folder = lammps_root(jobs), .ranks = given.lammps.ranks, .resume = given.lammps.resume});
  std::vector<Fault> unwritten = write_result([&] { streams.close(); });
  if (jobs.size() == 1) add_sensitivity(given, jobs.front(), outcomes.front());
  const bool talks = running.prints_text();
  std::vector<bool> written;
  for (std::size_t i = 0; i < jobs.size(); ++i) {  // all of them before any output, which may fail
    const std::vector<Fault> faults = write_result([&] {
      report::write(*jobs[i].folder, outcomes[i], version());
      jobs[i].folder->commit();
    });
    written.push_back(faults.empty());
    unwritten.insert(unwritten.end(), faults.begin(), faults.end());
  }
  if (kept && unwritten.empty() && std::ranges::all_of(outcomes, results::complete)) kept->remove();
  for (std::size_t i = 0; talks && i < jobs.size(); ++i)
    print_summary(jobs[i], outcomes[i], written[i]);
  if (running.json) print_json(jobs, outcomes, written);
  if (talks) fmt::print("computed in {} s\n", two_digits(outcomes.front().wall_seconds));
  if (!unwritten.empty()) return report_unwritten(unwritten, success);
  const int ended = report_exit_status(outcomes);
  if (kept && kept->write_error()) print_warning(*kept->write_error());
  const bool by_lammps = points.front().run.engine == cases::EngineName::lammps;
  if ((kept || by_lammps) && ended == interrupted && talks) fmt::print("to resume it:  --resume\n");
  return ended;
}

int run(const RunArguments& given) {
  catch_ctrl_c();
  std::vector<RunJob> plain, campaigns;
  for (RunJob& job : prepare_all(given))
    (job.sweeps() ? campaigns : plain).push_back(std::move(job));
  if (given.lammps.writes_only())
    return write_for_lammps(given.lammps, given.running, cases_of(plain), lammps_root(plain));
  int worst = plain.empty() ? success : run_cases(given, plain);
  for (const RunJob& job : campaigns) {
    if (worst == interrupted) break;
    worst =
        std::max<int>(worst, sweep_case(given.running, {}, job.file, given.overrides(), job.place));
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
               {"--resume", &given->lammps.resume, "resume an ended run from its last checkpoint"},
               json(given->running.json)}}),
      [given] { return run(*given); }};
}

}  // namespace mahlwerk::commands
