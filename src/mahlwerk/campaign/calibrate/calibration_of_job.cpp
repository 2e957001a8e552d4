// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The calibration of a case by its measurements, with runs at the centre of the posterior.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/number_text.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"
#include "mahlwerk/campaign/fit/minimiser.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {
namespace {

/// Turns values and range into the unit of the case, and sets the texts and the values of all
/// draws.
void use_unit_of_case(const cases::SweptKey& range, std::size_t key, CalibrationResult& found) {
  FittedParameter& p = found.parameters[key];
  const FreeParameter in_si = p;
  const auto text = [&](double value) {
    return value_in_range(range, position_of(in_si, value), 3);
  };
  p.text = {text(p.value), text(p.low), text(p.high), range.values[0], range.values[1]};
  p.unit = unit_of_range(range);
  const double one = p.unit.empty() ? 1 : parse_quantity("1 " + p.unit).value;
  for (double* number : {&p.value, &p.low, &p.high, &p.least, &p.most}) *number /= one;
  for (const DesignPoint& point : found.posterior)
    p.posterior.push_back(value_at(in_si, point[key]) / one);
}

/// The values of the conditions, if a single key makes them, as numbers in one unit.
void describe_conditions(const CalibrationJob& job, Calibration& made) {
  std::vector<double> values;
  for (const auto& condition : job.data.conditions) {
    if (condition.size() != 1 || condition.front().key != job.data.conditions.front().front().key)
      continue;
    try {
      const std::string unit(number_text(condition.front().value).rest);
      if (values.empty()) made.condition_unit = unit;
      if (unit == made.condition_unit) values.push_back(number_in(condition.front().value, unit));
    } catch (const UnitError&) {  // a word
    }
  }
  if (values.size() != job.data.conditions.size() || values.size() < 2) return;
  made.condition_key = job.data.conditions.front().front().key;
  made.condition_values = std::move(values);
}

/// A measurement beside prediction and runs. `replicates`: those at the centre, all outcomes each.
PredictedMeasurement predicted(const CalibrationJob& job, const CalibrationResult& found,
                               const std::vector<std::vector<double>>& replicates,
                               const Measurement& m) {
  const std::size_t outcome = job.outcome(m);
  std::vector<double> values;
  for (const auto& replicate : replicates)
    if (std::isfinite(replicate[outcome])) values.push_back(replicate[outcome]);
  PredictedMeasurement made{m, found.outcomes[outcome].value};
  made.simulated = observe::estimate(values);
  return made;
}

/// Whether the runs at the centre lie beyond the band and their own scatter.
bool beyond(const PredictedMeasurement& p) {
  const double half = std::isfinite(p.simulated.ci95) ? p.simulated.ci95 : 0;
  return p.simulated.mean + half < p.predicted.low || p.simulated.mean - half > p.predicted.high;
}

}  // namespace

double Calibration::emulator_error() const {
  double most = 0;
  for (const PredictedOutcome& p : result.outcomes) most = std::max(most, p.emulator_error);
  return most;
}

Calibration calibrate(CalibrationJob& job, const Simulation& run,
                      const CalibrationOptions& options) {
  constexpr int anew = 1'000'000;  // first replicate of the runs at the centre
  const TrialRuns& unchanged = job.unchanged.front();
  Calibration made;
  describe(made, job.base(), job.data_file, job.data);
  describe_conditions(job, made);
  const Simulation counted = [&](const std::vector<TrialRequest>& asked) {
    made.runs += static_cast<int>(asked.size() * job.conditions.size());
    return run(asked);
  };
  job.goal.snap = [&](const DesignPoint& p) { return unchanged.snap(p); };
  CalibrationResult& found = made.result = calibrate(job.goal, counted, options);
  if (options.progress) options.progress({.settings = found.settings, .at_centre = true});
  const std::vector<TrialResult> centre = counted({{.setting = 0,
                                                    .point = unchanged.snap(found.central),
                                                    .first = anew,
                                                    .count = std::max(4, job.goal.replicates)}});
  for (std::size_t i = 0; i < found.parameters.size(); ++i)
    use_unit_of_case(unchanged.ranges()[i], i, found);
  for (const Measurement& m : job.data.values)
    made.points.push_back(predicted(job, found, centre.front().replicates, m));
  if (const auto off = std::ranges::count_if(made.points, beyond); off > 0)
    found.remarks.push_back(fmt::format(
        "runs with the calibrated values differ from {} of {} predictions: the emulators are not "
        "good enough there, and more --settings help",
        off, made.points.size()));
  return made;
}

cases::Case calibrated_case(const CalibrationJob& job, const Calibration& found) {
  const TrialRuns& runs = job.unchanged.front();
  cases::Case made = runs.at(found.result.central, 0, static_cast<int>(job.base().run.replicates));
  const std::string source = fmt::format("calibrated to {}", found.data_file);
  for (const FittedParameter& p : found.result.parameters)
    for (cases::Origin& origin : made.origins)
      if (origin.key == p.name) origin.source = fmt::format("{}: {}", source, p.interval_text());
  cases::Uncertainty uncertainty{.source = source, .keys = {}};
  for (std::size_t i = 0; i < found.result.parameters.size(); ++i) {
    const std::string& key = found.result.parameters[i].name;
    if (!cases::is_key_of_draw(key)) continue;  // sizes, and the power meter: the central value
    uncertainty.keys.push_back({key, {}});
    for (const DesignPoint& point : found.result.draws)
      uncertainty.keys.back().values.push_back(runs.values(point)[i]);
  }
  if (!uncertainty.keys.empty()) made.uncertainty = std::move(uncertainty);
  return made;
}

}  // namespace mahlwerk::campaign
