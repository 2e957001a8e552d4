// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/runs/wear_evolution.hpp"

#include <fmt/format.h>

#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/state_file.hpp"
#include "mahlwerk/campaign/wear/wear_evolution.hpp"
#include "mahlwerk/campaign/wear/wear_tables.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/wear_evolution.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/files/file_lock.hpp"
#include "mahlwerk/results/files/manifest.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

constexpr const char* state_name = "wear_evolution.state";

std::string stage_name(std::size_t number) {
  return fmt::format("stage-{:03}", number);
}

/// Makes the folder, or opens that of an earlier run of the same case, whose state it returns. An
/// empty state: from the start.
std::string opened(const RunJob& job, bool force, campaign::StateFile& state) {
  std::error_code none;
  const bool is_free = !fs::exists(job.place, none) || fs::is_empty(job.place, none);
  if (!is_free && !force && fs::exists(state.file())) {
    try {
      state.load();
    } catch (const InputError& error) {
      Fault fault = error.faults().front();
      fault.remedy =
          "give the case and the settings that it was begun with, another folder with "
          "--out, or replace it with --force";
      throw InputError(fault);
    }
    return state.state(0);
  }
  if (!is_free) {
    { const results::Folder replaceable(job.place, force); }
    fs::remove_all(job.place);
  }
  results::make_folder(job.place);
  return "";
}

void write_files(const campaign::WearEvolution& all, const fs::path& place) {
  for (const results::NamedTable& one : campaign::wear_tables(all))
    results::write_whole(place / (one.name + ".csv"), results::csv(one.table));
  results::write_whole(place / "wear_evolution.json", report::wear_evolution_json(all, version()));
  results::write_whole(place / "wear_evolution.html", report::wear_evolution_page(all, version()));
  results::list_all_files(place);
}

void print_evolution(const campaign::WearEvolution& all, const fs::path& place) {
  title_to_stdout(all.title);
  to_stdout(fmt::format("\n{}\n", report::wear_evolution_text(all)));
  for (const Notice& one : all.notices)
    to_stdout(fmt::format("{}{}\n\n", one.warns() ? "Warning: " : "", one.text));
  places_to_stdout({{"results", place},
                    {"report", place / "wear_evolution.html"},
                    {"numbers", place / "wear_evolution.csv"}});
  to_stdout("\n");
}

/// Where a new stage goes, and what is kept after it.
campaign::WearOptions options_of(const Running& running, const RunJob& job, ProgressLine& line,
                                 campaign::StateFile& state) {
  campaign::WearOptions options;
  options.run = run_options(running.threads);
  const double evolve = *job.mill_case.parts.find<cases::Wear>()->evolve;
  const auto at = std::make_shared<std::pair<std::size_t, double>>();  // stage and time [s]
  options.begin = [at](std::size_t stage, double time) { *at = {stage, time}; };
  options.run.progress = [&line, at, evolve](const campaign::Progress& p) {
    line.show(fmt::format("stage {}, {:3.0f} % of the time of operation; its run {:3.0f} %  {}",
                          at->first, 100 * at->second / evolve,
                          p.total > 0 ? 100 * p.simulated / p.total : 0,
                          line.left(at->second / evolve)));
  };
  options.done = [&job](std::size_t stage, const results::Outcome& outcome) {
    results::Folder folder(job.place / stage_name(stage), true);
    report::write(folder, outcome, version(), "", false);
    folder.commit();
  };
  options.keep = [&state](std::string bytes) {
    state.set(0, std::move(bytes));
    state.write();
  };
  return options;
}

int end_of(const Running& running, const campaign::WearEvolution& all, const fs::path& place) {
  if (all.complete) return success;
  if (all.stop_reason.empty())
    return report_interrupted(running,
                              "stages that ended are kept; run the same command again to resume");
  return report_end(
      stopped_by_physics, "stopped: " + all.stop_reason,
      {Fault{place.string(), all.stop_reason, "stages until then are kept", "stopped"}});
}

}  // namespace

int evolve_wear(const Running& running, const RunJob& job) {
  campaign::StateFile state(job.place / state_name,
                            fmt::format("version {}\n{}{}", version(), cases::write(job.mill_case),
                                        cases::input_files_fingerprint(job.mill_case)),
                            1);
  const std::string kept = opened(job, running.force, state);
  const results::FileLock lock(job.place / "wear_evolution.lock",
                               results::FileLock::Mode::exclusive,
                               results::FileLock::AtRelease::remove_file);
  if (lock.state() == results::FileLock::State::held_elsewhere)
    throw InputError(Fault{job.place.string(), "another process follows the wear in this folder",
                           "wait until it ends, or give another folder with --out",
                           "result-at-work"});
  std::optional<ProgressLine> line(running.quiet);
  campaign::WearOptions options = options_of(running, job, *line, state);
  options.kept = kept;
  campaign::WearEvolution all = campaign::evolve_wear(job.mill_case, options);
  line.reset();
  if (!all.stages.empty()) {
    write_files(all, job.place);
    if (running.prints_text()) print_evolution(all, job.place);
  }
  if (running.json)
    json_to_stdout(results::Json::object(
        {{"title", all.title}, {"results", job.place.string()}, {"complete", all.complete}}));
  return end_of(running, all, job.place);
}

}  // namespace mahlwerk::commands
