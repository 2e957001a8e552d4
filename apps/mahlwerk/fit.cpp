// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// fit: fits parameters of a case to measurements.
#include "mahlwerk/campaign/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>

#include "calibrate.hpp"
#include "command.hpp"
#include "compute.hpp"
#include "fit_report.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/results/files/writer.hpp"
#include "messages.hpp"
#include "output.hpp"
#include "progress.hpp"

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

/// Runs each mill once. Its result files are not kept.
std::vector<results::Outcome> run_mills(const Request& request, const campaign::FitJob& job,
                                        const results::Folder& folder) {
  campaign::Streams streams(version());
  for (const cases::Case& mill : job.mills) streams.add(mill, folder, "");
  return compute(request, job.mills, streams, nullptr);
}

campaign::Fit find(const Request& request, const campaign::FitJob& job,
                   const std::vector<results::Outcome>& mills) {
  ProgressLine line(request.quiet);
  return campaign::fit(mills, job.data, job.parameters,
                       {.threads = request.threads, .stop = &stop_wanted(), .progress = [&](int n) {
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

int report_interrupted() {
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
  return report_interrupted();
}

int fit(const Request& request) {
  const fs::path file = one_case_file(request.target, "fit");
  if (campaign::calibrates(file, overrides(request))) return calibrate(request, file);
  const campaign::FitJob job =
      campaign::fit_job(file, request.data, catalogue(), overrides(request));
  const fs::path usual = default_folder(request.target, file, false).string() + "-fit";
  results::Folder folder(request.out.value_or(usual), request.force);

  catch_ctrl_c();
  const std::vector<results::Outcome> mills = run_mills(request, job, folder);
  if (const int code = cut_short(mills); code != success) return code;
  try {
    const campaign::Fit found = find(request, job, mills);
    const report::FitReport report = fit_report(job, mills, found);
    write(folder, job, report);
    if (request.json) json_to_stdout(fit_json(report, version()));
    if (!request.json && !request.quiet) print_summary(report, folder.target());
  } catch (const Interrupted&) {
    return report_interrupted();
  }
  return success;
}

}  // namespace

Command fit_command() {
  return {"fit",
          "fit parameters of a case to measurements of the powder or of the mill, with intervals",
          joined({{one_case(),
                   {.name = "DATA",
                    .target = &Request::data,
                    .about = "table of measurements: CSV, see docs/formats.md",
                    .required = true}},
                  changes(),
                  {{.name = "--settings",
                    .target = &Request::settings,
                    .about = "largest number of settings that are run for keys of [contact] and "
                             "[mill]; by default 20, and 20 for each key",
                    .range = {5, 100'000}}},
                  running(", with -fit"),
                  {resumable_checkpoint(), json()}}),
          fit};
}

}  // namespace mahlwerk::app
