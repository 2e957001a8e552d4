// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// fit: fits parameters of a case to measurements.
#include "mahlwerk/report/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <functional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/campaign/fit/job.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/searches/calibrate.hpp"
#include "mahlwerk/commands/searches/searching.hpp"
#include "mahlwerk/report/study_json.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

/// Runs each mill once. Its result files are not kept.
std::vector<results::Outcome> run_mills(const FitArguments& given, const campaign::FitJob& job,
                                        const results::Folder& folder, ResumableSearch& kept) {
  campaign::Streams streams(version());
  for (const cases::Case& mill : job.mills) streams.add(mill, folder, "");
  return compute(given.running, job.mills, streams, kept.runs(), given.checkpoint);
}

/// Text of all inputs that determine the evaluations of a fit.
std::string identity_of(const campaign::FitJob& job) {
  std::string text = fmt::format("version {}\n", version());
  for (const cases::Case& mill : job.mills)
    text += cases::write(mill) + cases::input_files_fingerprint(mill);
  for (const campaign::FreeParameter& p : job.parameters)
    text += fmt::format("{} {} {}\n", p.name, p.least, p.most);
  for (const campaign::Measurement& m : job.data.values)
    text += fmt::format("{} {} {} {} {} {} {}\n", static_cast<int>(m.what), m.condition, m.time,
                        m.percent, m.size, m.value, m.error);
  return text;
}

campaign::Fit find(const Running& running, const campaign::FitJob& job,
                   const std::vector<results::Outcome>& mills, campaign::FitEvaluations& kept) {
  if (kept.count() > 0 && running.prints_text())
    to_stderr(fmt::format("resuming a fit with {} kept evaluations\n", kept.count()));
  ProgressLine line(running.quiet);
  return campaign::fit(
      job, mills,
      {.threads = running.threads,
       .stop = &stop_wanted(),
       .progress =
           [&](int n, int usual) {
             line.show(fmt::format("fitting: {} of about {} evaluations of the powder model  {}", n,
                                   usual, line.left(static_cast<double>(n) / usual)));
           },
       .kept = &kept});
}

/// The best values so far as part of a message; empty if none was found.
std::string best_so_far(const campaign::FitJob& job, const campaign::FitEvaluations& kept) {
  if (!kept.best()) return "";
  const std::vector<cases::FitParameter> known = cases::fit_parameters(job.base);
  std::string list;
  for (std::size_t i = 0; i < job.parameters.size(); ++i) {
    const auto of = std::ranges::find(known, job.parameters[i].name, &cases::FitParameter::key);
    const std::string unit = of == known.end() ? "" : of->unit;
    list += fmt::format("{}{} = {:.4g}{}{}", i > 0 ? ", " : "", job.parameters[i].name,
                        kept.best()->values[i], unit.empty() ? "" : " ", unit);
  }
  return fmt::format("the best of {} evaluations so far is {} (sum of squares {:.4g}); ",
                     kept.count(), list, kept.best()->sum);
}

void write(results::Folder& folder, const campaign::FitJob& job, const campaign::Fit& found) {
  folder.write("fit.json", report::fit_json(found, version()).text(2) + '\n');
  folder.write("fit.csv", report::fit_csv(found));
  folder.write("fit.html", report::fit_page(found, version()));
  results::write_case(folder, campaign::fitted_case(job, found), "fitted.toml");
  folder.commit();
}

/// A fit needs complete runs of all mills: reports a run that was stopped.
int report_stopped(const std::vector<results::Outcome>& mills) {
  for (const results::Outcome& mill : mills)
    for (const results::Replicate& r : mill.replicates)
      if (!r.stop_reason.empty())
        return report_end(stopped_by_physics,
                          fmt::format("stopped: {}\nNothing was fitted.", r.stop_reason),
                          {Fault{"", r.stop_reason, "nothing was fitted", "stopped"}});
  return success;
}

/// Fits, writes and prints the result. `kept` is removed once it is written.
int fit_powder(const FitArguments& given, const campaign::FitJob& job, results::Folder& folder,
               ResumableSearch& kept) {
  const Running& running = given.running;
  const std::vector<results::Outcome> mills = run_mills(given, job, folder, kept);
  if (const int code = report_stopped(mills); code != success) return code;
  if (stop_wanted()) return kept.report_interrupted();
  WriteErrorReporter not_kept;
  campaign::FitEvaluations evaluations(kept.trials(), identity_of(job),
                                       given.checkpoint.value_or(1), std::ref(not_kept));
  try {
    const campaign::Fit found = find(running, job, mills, evaluations);
    not_kept.repeat();
    const std::vector<Fault> unwritten = write_result([&] { write(folder, job, found); });
    if (unwritten.empty())
      kept.remove();
    else
      evaluations.flush();
    const auto print = [&] {
      if (running.json) json_to_stdout(report::fit_json(found, version()));
      const fs::path& place = folder.target();
      if (running.prints_text())
        print_found(found.title + "\n\n" + report::fit_table(found),
                    {{"results", place},
                     {"report", place / "fit.html"},
                     {"numbers", place / "fit.json"},
                     {"case", place / "fitted.toml"}},
                    unwritten.empty());
    };
    return print_result(print, unwritten, success);
  } catch (const Interrupted&) {
    evaluations.flush();
    return kept.report_interrupted(best_so_far(job, evaluations));
  }
}

int fit(const FitArguments& given) {
  const Running& running = given.running;
  const fs::path file = one_case_file(given.target, "fit");
  const std::vector<cases::Override> set = given.changes.overrides();
  if (campaign::calibrates(file, set)) return calibrate(given, file);
  const campaign::FitJob job = campaign::fit_job(file, given.data, catalogue(), set);
  const fs::path usual = default_folder(given.target, file, false).string() + "-fit";
  catch_ctrl_c();
  results::Folder folder(running.out.value_or(usual), running.force);
  folder.reserve();
  ResumableSearch kept(folder.target(), "evaluations", "the evaluations of the fit");
  return fit_powder(given, job, folder, kept);
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
                    .about = "largest number of settings that are run for keys of the mill; by "
                             "default 20, and 20 for each key",
                    .range = {5, 100'000}}},
                  options_of(given->running, ", with -fit"),
                  {resumable_checkpoint(given->checkpoint), json(given->running.json)}}),
          [given] { return fit(*given); }};
}

}  // namespace mahlwerk::commands
