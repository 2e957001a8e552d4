// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Calibration of keys of a case by measurements on the mill.
#include "mahlwerk/commands/searches/calibrate.hpp"

#include <fmt/format.h>

#include <functional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/searches/searching.hpp"
#include "mahlwerk/report/calibration.hpp"
#include "mahlwerk/report/study_json.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;
using campaign::CalibrationJob;

campaign::Calibration find_calibration(const Running& running, CalibrationJob& job,
                                       const ResumableSearch& kept) {
  ProgressLine line(running.quiet);
  const campaign::RunOptions options = run_options(running.threads);
  WriteErrorReporter not_kept;
  campaign::TrialStore store(kept.trials(), job.measure_name, std::ref(not_kept));
  results::NoticeCounts notices;
  const auto run = [&](const std::vector<campaign::TrialRequest>& asked) {
    return campaign::run_settings(job, asked, options, store, version(), notices);
  };
  const auto show = [&](const campaign::CalibrationProgress& p) {
    line.show(p.at_centre
                  ? "running the calibrated case"
                  : fmt::format("{} of at most {} settings, round {}  {}", p.settings, p.of,
                                p.rounds + 1, line.left(static_cast<double>(p.settings) / p.of)));
  };
  campaign::Calibration found =
      campaign::calibrate(job, run, {.stop = &stop_wanted(), .progress = show});
  found.notices = std::move(notices);
  results::sort(found.notices);
  not_kept.repeat();
  return found;
}

}  // namespace

int calibrate(const FitArguments& given, const fs::path& file) {
  const Running& running = given.running;
  const cases::Catalogue known = catalogue();
  CalibrationJob job =
      campaign::calibration_job(file, given.data, known, given.changes.overrides(), given.settings);
  const fs::path usual = default_folder(given.target, file, false).string() + "-fit";
  catch_ctrl_c();
  results::Folder folder(running.out.value_or(usual), running.force);
  folder.reserve();
  ResumableSearch kept(folder.target());
  try {
    const campaign::Calibration found = find_calibration(running, job, kept);
    const std::vector<Fault> unwritten = write_result([&] {
      folder.write("fit.json", report::calibration_json(found, version()).text(2) + '\n');
      folder.write("fit.csv", report::calibration_csv(found));
      folder.write("posterior.csv", report::posterior_csv(found));
      folder.write("fit.html", report::calibration_page(found, version()));
      results::write_case(folder, campaign::calibrated_case(job, found), "calibrated.toml");
      folder.commit();
    });
    if (unwritten.empty()) kept.remove();
    const auto print = [&] {
      if (running.json) json_to_stdout(report::calibration_json(found, version()));
      const fs::path& place = folder.target();
      if (running.prints_text())
        print_found(found.title + "\n\n" + report::calibration_table(found),
                    {{"results", place},
                     {"report", place / "fit.html"},
                     {"numbers", place / "fit.json"},
                     {"case", place / "calibrated.toml"}},
                    unwritten.empty());
    };
    return print_result(print, unwritten, success);
  } catch (const Interrupted&) {
    return kept.report_interrupted();
  }
}

}  // namespace mahlwerk::commands
