// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// optimise: finds the settings of a mill that maximise or minimise a quantity.
#include <fmt/format.h>

#include <cstdio>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/searches/searching.hpp"
#include "mahlwerk/report/optimum.hpp"
#include "mahlwerk/report/study_json.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

void write(const results::Folder& folder, const campaign::Optimum& found) {
  folder.write("optimise.json", report::optimum_json(found, version()).text(2) + '\n');
  folder.write("settings.csv", report::optimum_csv(found));
  folder.write("optimise.html", report::optimum_page(found, version()));
}

void print_summary(const campaign::Optimum& found, const fs::path& place, bool written) {
  Places paths{{"results", place},
               {"report", place / "optimise.html"},
               {"settings", place / "settings.csv"}};
  if (found.best) paths.emplace_back("case", place / "best.toml");
  print_found(fmt::format("{}\n\n{}", found.title, report::optimum_table(found)), paths, written);
}

int optimise(const CaseArguments& given) {
  const Running& running = given.running;
  const fs::path file = one_case_file(given.target, "optimise");
  const cases::Catalogue known = catalogue();
  const std::vector<cases::Override> set = given.changes.overrides();
  const cases::Case mill_case = cases::read(file, known, set);
  if (!mill_case.optimise)
    throw InputError(Fault{mill_case.file, "the case has no [optimise]",
                           "name the quantity and the keys to vary: [optimise] with maximise = "
                           "\"dissipated_power\" and over = { \"mill.speed\" = { from = \"200 "
                           "rpm\", to = \"600 rpm\" } }",
                           "nothing-to-optimise"});
  campaign::check_keys(mill_case, mill_case.optimise->over, "[optimise]");
  const campaign::TrialRuns runs(file, known, set, cases::ValueSource::optimise);
  const campaign::SearchJob job = campaign::optimise_job(runs);
  const fs::path usual = default_folder(given.target, file, false).string() + "-optimise";
  catch_ctrl_c();
  results::Folder folder(running.out.value_or(usual), running.force);
  folder.reserve();
  ResumableSearch kept(folder.target());
  try {
    campaign::Optimum found = run_search(running, job, kept);
    found.check = check_best(running, job, found, kept);
    const std::vector<Fault> unwritten = write_result([&] {
      write(folder, found);
      if (found.best) {
        const int count = static_cast<int>(runs.base().run.replicates);
        results::write_case(folder, runs.at(found.trials[*found.best].point, 0, count),
                            "best.toml");
      }
      folder.commit();
    });
    if (unwritten.empty()) kept.remove();
    const auto print = [&] {
      if (running.json) json_to_stdout(report::optimum_json(found, version()));
      if (running.prints_text()) print_summary(found, folder.target(), unwritten.empty());
    };
    return print_result(print, unwritten, found.best ? success : stopped_by_physics);
  } catch (const Interrupted&) {
    return kept.report_interrupted();
  }
}

}  // namespace

Command optimise_command() {
  const auto given = std::make_shared<CaseArguments>();
  return {"optimise",
          "find the settings that maximise or minimise a quantity: [optimise] of the case",
          joined({{one_case(given->target)},
                  options_of(given->changes),
                  options_of(given->running, ", with -optimise"),
                  {json(given->running.json)}}),
          [given] { return optimise(*given); }};
}

}  // namespace mahlwerk::commands
