// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// compare: runs one case with both engines and shows the results side by side.
#include "mahlwerk/report/compare.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/report/report.hpp"
#include "mahlwerk/report/study_json.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

struct CompareArguments : CaseArguments {
  std::optional<double> checkpoint;  ///< [s]
};

constexpr std::array<const char*, 2> engines{"event", "soft"};

std::string below(std::size_t engine) {
  return std::string(engines[engine]) + "/";
}

/// The case for each engine, in the order of `engines`. Throws InputError if one cannot run it.
std::vector<cases::Case> both(std::vector<cases::Override> set, const fs::path& file) {
  const cases::Catalogue known = catalogue();
  std::vector<cases::Case> made;
  std::vector<Fault> wrong;
  set.push_back({"run.engine", ""});
  for (const char* engine : engines) {
    set.back().value = engine;
    made.push_back(cases::read(file, known, set));
    if (const cases::Case& mill_case = made.back(); !mill_case.sweep.empty())
      throw InputError(Fault{mill_case.file, "the case has a [sweep], compare takes a single case",
                             "remove the section [sweep]; --set sets one of its values",
                             "one-case"});
    for (Fault& fault : campaign::run_faults(made.back())) {
      fault.what = fmt::format("the {} engine cannot run this case: {}", engine, fault.what);
      wrong.push_back(std::move(fault));
    }
  }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

void write(results::Folder& folder, const std::vector<results::Outcome>& outcomes,
           const report::Comparison& comparison) {
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    report::write(folder, outcomes[i], version(), below(i));
  folder.write("compare.csv", report::compare_csv(comparison));
  folder.write("compare.json", report::comparison_json(comparison, version()).text(2) + '\n');
  folder.write("compare.html", report::compare_page(comparison, version()));
  folder.commit();
}

void print_json(const report::Comparison& comparison, const fs::path& place) {
  results::Json all = report::comparison_json(comparison, version());
  all["results"] = place.string();
  json_to_stdout(all);
}

void print_summary(const report::Comparison& comparison, const fs::path& place, double seconds,
                   bool written) {
  title_to_stdout(comparison.title);
  to_stdout(fmt::format("\n{}\n", report::compare_table(comparison)));
  if (!written) return;
  places_to_stdout(
      {{"results", place}, {"report", place / "compare.html"}, {"numbers", place / "compare.csv"}});
  fmt::print("\ncomputed in {} s\n", two_digits(seconds));
}

int compare(const CompareArguments& given) {
  const Running& running = given.running;
  const fs::path file = one_case_file(given.target, "compare");
  const std::vector<cases::Case> cases = both(given.changes.overrides(), file);
  const fs::path usual = default_folder(given.target, file, false).string() + "-compare";
  const fs::path place = running.out.value_or(usual);
  catch_ctrl_c();
  results::Folder folder(place, running.force);
  folder.reserve();
  campaign::ResumableRuns kept(folder.target());
  campaign::Streams streams(version());
  for (std::size_t i = 0; i < cases.size(); ++i) streams.add(cases[i], folder, below(i));
  const std::vector<results::Outcome> outcomes =
      compute(running, cases, streams, kept, given.checkpoint);
  if (stop_wanted() && !std::ranges::all_of(outcomes, results::complete))
    return report_interrupted(running, fmt::format("the runs are kept in {}; run the same command "
                                                   "again to resume",
                                                   kept.folder().string()));
  const report::Comparison comparison = report::compare(outcomes[0], outcomes[1]);
  const std::vector<Fault> unwritten = write_result([&] {
    streams.close();
    write(folder, outcomes, comparison);
  });
  if (unwritten.empty()) kept.remove();
  const auto print = [&] {
    if (running.json) print_json(comparison, folder.target());
    if (running.prints_text())
      print_summary(comparison, folder.target(), outcomes.front().wall_seconds, unwritten.empty());
  };
  const int printed = print_result(print, unwritten, success);
  return unwritten.empty() ? report_exit_status(outcomes) : printed;
}

}  // namespace

Command compare_command() {
  const auto given = std::make_shared<CompareArguments>();
  return {"compare", "run a case with both engines and show the results side by side",
          joined({{one_case(given->target)},
                  options_of(given->changes),
                  options_of(given->running, ", with -compare"),
                  {resumable_checkpoint(given->checkpoint), json(given->running.json)}}),
          [given] { return compare(*given); }};
}

}  // namespace mahlwerk::commands
