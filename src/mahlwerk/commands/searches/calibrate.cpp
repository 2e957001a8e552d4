// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Calibration of keys of a case by measurements on the mill.
#include "mahlwerk/commands/searches/calibrate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/campaign/fit/minimiser.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/commands/compute.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/commands/reporting/progress.hpp"
#include "mahlwerk/commands/reporting/result_files.hpp"
#include "mahlwerk/commands/searches/fit_report.hpp"
#include "mahlwerk/commands/searches/searching.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/report/calibration.hpp"
#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/files/json.hpp"
#include "mahlwerk/results/files/writer.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;
using campaign::CalibrationJob;
using campaign::CalibrationResult;
using results::Json;

/// A calibration and the runs at its centre.
struct Found {
  CalibrationResult result;
  std::vector<std::vector<double>> replicates;  // at the centre; by replicate, all outcomes
  results::NoticeCounts notices;
  int runs = 0;
};

Found find_calibration(const Running& running, CalibrationJob& job, const ResumableSearch& kept) {
  constexpr int anew = 1'000'000;  // first replicate of the runs at the centre
  ProgressLine line(running.quiet);
  const campaign::RunOptions options = run_options(running.threads);
  WriteErrorReporter not_kept;
  campaign::TrialStore store(kept.trials(), job.measure_name, std::ref(not_kept));
  Found found;
  const auto run = [&](const std::vector<campaign::TrialRequest>& asked) {
    found.runs += static_cast<int>(asked.size() * job.conditions.size());
    return campaign::run_settings(job, asked, options, store, version(), found.notices);
  };
  job.goal.snap = [&job](const campaign::DesignPoint& p) { return job.unchanged.front().snap(p); };
  found.result = campaign::calibrate(
      job.goal, run,
      {.stop = &stop_wanted(), .progress = [&](const campaign::CalibrationProgress& p) {
         line.show(
             fmt::format("{} of at most {} settings, round {}", p.settings, p.of, p.rounds + 1));
       }});
  line.show("running the calibrated case");
  const int count = std::max(4, job.goal.replicates);
  found.replicates = run({{.setting = 0,
                           .point = job.unchanged.front().snap(found.result.central),
                           .first = anew,
                           .count = count}})
                         .front()
                         .replicates;
  results::sort(found.notices);
  not_kept.repeat();
  return found;
}

report::CalibratedKey calibrated_key(const CalibrationJob& job, const CalibrationResult& found,
                                     std::size_t i) {
  const cases::SweptKey& range = job.unchanged.front().ranges()[i];
  const campaign::FreeParameter& parameter = job.goal.parameters[i];
  const campaign::FittedParameter& p = found.parameters[i];
  const auto text = [&](double value) {
    return campaign::value_in_range(range, campaign::position_of(parameter, value), 3);
  };
  const double one = unit_of(range).empty() ? 1 : parse_quantity("1 " + unit_of(range)).value;
  report::CalibratedKey made{.key = range.key,
                             .unit = unit_of(range),
                             .from = range.values[0],
                             .to = range.values[1],
                             .least = parameter.least / one,
                             .most = parameter.most / one,
                             .value = text(p.value),
                             .low = text(p.low),
                             .high = text(p.high),
                             .number = p.value / one,
                             .number_low = p.low / one,
                             .number_high = p.high / one,
                             .open_low = p.open_low,
                             .open_high = p.open_high,
                             .determined = p.determined,
                             .remarks = p.remarks};
  for (const auto& point : found.posterior)
    made.posterior.push_back(campaign::value_at(parameter, point[i]) / one);
  return made;
}

/// The values of the conditions, if a single key makes them, as numbers in one unit.
void describe_conditions(const CalibrationJob& job, report::CalibrationReport& made) {
  std::vector<double> values;
  for (const auto& condition : job.data.conditions) {
    made.conditions.push_back(condition_label(condition));
    if (condition.size() != 1 || condition.front().key != job.data.conditions.front().front().key)
      continue;
    try {
      const std::string unit(number_text(condition.front().value).rest);
      if (values.empty()) made.condition_unit = unit;
      if (unit == made.condition_unit)
        values.push_back(parse_quantity(condition.front().value).value /
                         (unit.empty() ? 1 : parse_quantity("1 " + unit).value));
    } catch (const UnitError&) {  // a word
    }
  }
  if (values.size() != job.data.conditions.size() || values.size() < 2) return;
  made.condition_key = job.data.conditions.front().front().key;
  made.condition_values = std::move(values);
}

report::CalibratedPoint point_of(const CalibrationJob& job, const Found& found,
                                 const campaign::Measurement& m) {
  const std::size_t outcome = job.outcome(m);
  std::vector<double> values;
  for (const auto& replicate : found.replicates)
    if (std::isfinite(replicate[outcome])) values.push_back(replicate[outcome]);
  const campaign::PredictedOutcome& p = found.result.outcomes[outcome];
  report::CalibratedPoint made{.what = m.name(),
                               .unit = m.unit(),
                               .condition = m.condition,
                               .fall = m.fall,
                               .measured = m.value,
                               .error = m.error,
                               .predicted = p.mean,
                               .low = p.low,
                               .high = p.high,
                               .simulated = NAN,
                               .ci95 = NAN,
                               .line = m.line};
  if (values.empty()) return made;
  const observe::Estimate e = observe::estimate(values);
  made.simulated = e.mean;
  made.ci95 = e.ci95;
  return made;
}

/// Whether the runs at the centre lie beyond the band and their own scatter.
bool beyond(const report::CalibratedPoint& p) {
  const double half = std::isfinite(p.ci95) ? p.ci95 : 0;
  return p.simulated + half < p.low || p.simulated - half > p.high;
}

report::CalibrationReport calibration_report(const CalibrationJob& job, const Found& found) {
  const CalibrationResult& result = found.result;
  report::CalibrationReport made{.title = job.base().title,
                                 .case_file = job.base().file,
                                 .data_file = job.data_file,
                                 .correlation = result.correlation,
                                 .remarks = result.remarks,
                                 .notices = found.notices,
                                 .misfit = result.misfit,
                                 .scatter = result.scatter,
                                 .emulator_share = result.emulator_share,
                                 .settings = result.settings,
                                 .failed = result.failed,
                                 .runs = found.runs,
                                 .draws = static_cast<int>(result.draws.size()),
                                 .errors_known = job.data.errors_known(),
                                 .converged = result.converged};
  for (std::size_t i = 0; i < job.goal.parameters.size(); ++i)
    made.keys.push_back(calibrated_key(job, result, i));
  describe_conditions(job, made);
  for (const campaign::Measurement& m : job.data.values)
    made.points.push_back(point_of(job, found, m));
  for (const campaign::PredictedOutcome& p : result.outcomes)
    made.emulator_error = std::max(made.emulator_error, p.emulator_error);
  if (const auto off = std::ranges::count_if(made.points, beyond); off > 0)
    made.remarks.push_back(fmt::format(
        "runs with the calibrated values differ from {} of {} predictions: the emulators are not "
        "good enough there, and more --settings help",
        off, made.points.size()));
  return made;
}

Json json_of(const report::CalibrationReport& found) {
  Json keys = Json::object(), points = Json::array();
  for (const report::CalibratedKey& k : found.keys)
    keys[k.key] = Json::object({{"value", k.number},
                                {"low", k.open_low ? Json() : Json(k.number_low)},
                                {"high", k.open_high ? Json() : Json(k.number_high)},
                                {"unit", k.unit},
                                {"determined", k.determined},
                                {"range", Json::array({k.least, k.most})},
                                {"remarks", k.remarks}});
  for (const report::CalibratedPoint& p : found.points)
    points.push_back(Json::object({{"line", p.line},
                                   {"condition", found.conditions[p.condition]},
                                   {"what", p.what},
                                   {"unit", p.unit},
                                   {"measured", p.measured},
                                   {"error", p.error},
                                   {"predicted", p.predicted},
                                   {"predicted_low", p.low},
                                   {"predicted_high", p.high},
                                   {"simulated", p.simulated},
                                   {"simulated_ci95", p.ci95}}));
  return Json::object({{"mahlwerk", version()},
                       {"title", found.title},
                       {"case", found.case_file},
                       {"data", found.data_file},
                       {"all_determined", found.all_determined()},
                       {"numbers", std::move(keys)},
                       {"correlation", found.correlation},
                       {"conditions", found.conditions},
                       {"values", std::move(points)},
                       {"errors_known", found.errors_known},
                       {"misfit", found.misfit},
                       {"scatter", found.scatter},
                       {"settings", found.settings},
                       {"failed", found.failed},
                       {"runs", found.runs},
                       {"converged", found.converged},
                       {"emulator_error", found.emulator_error},
                       {"emulator_share", found.emulator_share},
                       {"draws", found.draws},
                       {"remarks", found.remarks},
                       {"notices", results::notices_json(found.notices)}});
}

/// The case with the most central draw as values, and the others as [uncertainty].
cases::Case calibrated_case(const CalibrationJob& job, const Found& found,
                            const report::CalibrationReport& report) {
  const campaign::TrialRuns& runs = job.unchanged.front();
  cases::Case made = runs.at(found.result.central, 0, static_cast<int>(job.base().run.replicates));
  const std::string source = fmt::format("calibrated to {}", report.data_file);
  for (const report::CalibratedKey& k : report.keys)
    for (cases::Origin& origin : made.origins)
      if (origin.key == k.key) origin.source = fmt::format("{}: {}", source, k.interval_text());
  cases::Uncertainty& uncertainty = made.uncertainty.emplace();
  uncertainty.source = source;
  for (const report::CalibratedKey& k : report.keys) uncertainty.keys.push_back({k.key, {}});
  for (const campaign::DesignPoint& point : found.result.draws) {
    const std::vector<std::string> values = runs.values(point);
    for (std::size_t i = 0; i < values.size(); ++i) uncertainty.keys[i].values.push_back(values[i]);
  }
  return made;
}

void print_summary(const report::CalibrationReport& found, const fs::path& place, bool written) {
  to_stdout(fmt::format("{}\n\n{}\n", found.title, report::calibration_table(found)));
  if (!written) return;
  fmt::print("results:  {}\n", place.string());
  fmt::print("report:   {}\n", (place / "fit.html").string());
  fmt::print("numbers:  {}\n", (place / "fit.json").string());
  fmt::print("case:     {}\n", (place / "calibrated.toml").string());
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
    const Found found = find_calibration(running, job, kept);
    const report::CalibrationReport report = calibration_report(job, found);
    const std::vector<Fault> unwritten = write_result([&] {
      folder.write("fit.json", json_of(report).text(2) + '\n');
      folder.write("fit.csv", report::calibration_csv(report));
      folder.write("posterior.csv", report::posterior_csv(report));
      folder.write("fit.html", report::calibration_page(report, version()));
      results::write_case(folder, calibrated_case(job, found, report), "calibrated.toml");
      folder.commit();
    });
    if (unwritten.empty()) kept.remove();
    const auto print = [&] {
      if (running.json) json_to_stdout(json_of(report));
      if (running.prints_text()) print_summary(report, folder.target(), unwritten.empty());
    };
    return print_result(print, unwritten, success);
  } catch (const Interrupted&) {
    return kept.report_interrupted();
  }
}

}  // namespace mahlwerk::commands
