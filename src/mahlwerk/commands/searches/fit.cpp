// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// fit: fits parameters of a case to measurements.
#include "mahlwerk/campaign/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/searches/calibrate.hpp"
#include "mahlwerk/commands/searches/fit_report.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

/// Runs each mill once. Its result files are not kept.
std::vector<results::Outcome> run_mills(const Running& running, const campaign::FitJob& job,
                                        const results::Folder& folder) {
  campaign::Streams streams(version());
  for (const cases::Case& mill : job.mills) streams.add(mill, folder, "");
  return compute(running, job.mills, streams);
}

campaign::Fit find(const Running& running, const campaign::FitJob& job,
                   const std::vector<results::Outcome>& mills) {
  ProgressLine line(running.quiet);
  return campaign::fit(mills, job.data, job.parameters,
                       {.threads = running.threads, .stop = &stop_wanted(), .progress = [&](int n) {
                          line.show(fmt::format("fitting: {} evaluations of the powder model", n));
                        }});
}

void write(results::Folder& folder, const campaign::FitJob& job, const report::FitReport& found) {
  folder.write("fit.json", fit_json(found, version()).text(2) + '\n');
  folder.write("fit.csv", report::fit_csv(found));
  folder.write("fit.html", report::fit_page(found, version()));
  results::write_case(folder, fitted_case(job, found), "fitted.toml");
  folder.commit();
}

void print_summary(const report::FitReport& found, const fs::path& place) {
  to_stdout(fmt::format("{}\n\n{}\n", found.title, report::fit_table(found)));
  fmt::print("results:  {}\n", place.string());
  fmt::print("report:   {}\n", (place / "fit.html").string());
  fmt::print("numbers:  {}\n", (place / "fit.json").string());
  fmt::print("case:     {}\n", (place / "fitted.toml").string());
}

int report_no_fit() {
  return report_end(interrupted, "interrupted: nothing was fitted.",
                    {Fault{"", "interrupted", "nothing was fitted", "interrupted"}});
}

/// A fit needs complete runs of all mills: reports a run that stopped or was interrupted, and
/// returns its exit code.
int cut_short(const std::vector<results::Outcome>& mills) {
  if (std::ranges::all_of(mills, results::complete)) return success;
  for (const results::Outcome& mill : mills)
    for (const results::Replicate& r : mill.replicates)
      if (!r.stop_reason.empty())
        return report_end(stopped_by_physics,
                          fmt::format("stopped: {}\nNothing was fitted.", r.stop_reason),
                          {Fault{"", r.stop_reason, "nothing was fitted", "stopped"}});
  return report_no_fit();
}

int fit(const FitArguments& given) {
  const Running& running = given.running;
  const fs::path file = one_case_file(given.target, "fit");
  const std::vector<cases::Override> set = given.changes.overrides();
  if (campaign::calibrates(file, set)) return calibrate(given, file);
  const campaign::FitJob job = campaign::fit_job(file, given.data, catalogue(), set);
  const fs::path usual = default_folder(given.target, file, false).string() + "-fit";
  results::Folder folder(running.out.value_or(usual), running.force);

  catch_ctrl_c();
  const std::vector<results::Outcome> mills = run_mills(running, job, folder);
  if (const int code = cut_short(mills); code != success) return code;
  try {
    const campaign::Fit found = find(running, job, mills);
    const report::FitReport report = fit_report(job, mills, found);
    write(folder, job, report);
    if (running.json) json_to_stdout(fit_json(report, version()));
    if (running.prints_text()) print_summary(report, folder.target());
  } catch (const Interrupted&) {
    return report_no_fit();
  }
  return success;
}

}  // namespace

Command fit_command() {
  const auto given = std::make_shared<FitArguments>();
  return {"fit",
          "fit parameters of a case to measurements of the powder or of the mill, with intervals",
          joined({{one_case(given->target),
                   {.name = "DATA",
                    .target = &given->data,
                    .about = "table of measurements: CSV, see docs/formats.md",
                    .required = true}},
                  options_of(given->changes),
                  {{.name = "--settings",
                    .target = &given->settings,
                    .about = "largest number of settings that are run for keys of [contact] and "
                             "[mill]; by default 20, and 20 for each key",
                    .range = {5, 100'000}}},
                  options_of(given->running, ", with -fit"),
                  {resumable_checkpoint(given->checkpoint), json(given->running.json)}}),
          [given] { return fit(*given); }};
}

}  // namespace mahlwerk::commands
