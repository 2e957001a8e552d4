// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/calibrate/calibration_job.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/campaign/search/search_job.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/read.hpp"

namespace mahlwerk::campaign {
namespace {

namespace fs = std::filesystem;
using Overrides = std::vector<cases::Override>;

LabQuantity quantity_of(const Measurement& m) {
  return {m.name(), m.unit(), m.what == MeasuredQuantity::rebound_height ? m.fall : 0};
}

/// Faults of what is measured and what is free.
std::vector<Fault> job_faults(const CalibrationJob& job, const Overrides& set) {
  std::vector<Fault> found;
  for (const auto& [key, range] : job.base().fit)
    if (!cases::is_key_of_run(key) && !cases::gives_value(set, key))
      found.push_back({cases::location_of(job.base(), "fit." + key),
                       fmt::format("[fit] has {} of the powder beside keys of the mill", key),
                       "calibrate the mill first: remove it, or give it by --set; then fit the "
                       "powder with calibrated.toml",
                       "mixed-fit"});
  for (const Measurement& m : job.data.values)
    if (of_powder(m.what)) {
      found.push_back(
          {fmt::format("{}:{}", job.data_file, m.line),
           fmt::format("{} was measured on the powder, but [fit] has keys of the mill", m.name()),
           "calibrate the mill with measurements on the mill; then fit the powder with "
           "calibrated.toml",
           "mixed-fit"});
      break;
    }
  for (const FreeParameter& parameter : job.goal.parameters)
    if (std::ranges::any_of(job.data.conditions, [&](const Overrides& one) {
          return cases::gives_value(one, parameter.name);
        }))
      found.push_back({job.data_file,
                       fmt::format("the column {} sets a parameter of [fit]", parameter.name),
                       "remove the column or the key of [fit]", "nothing-to-fit"});
  return found;
}

/// Each fault once; those of a condition cite the table.
void add_faults(std::vector<Fault> faults, const Overrides& condition, const std::string& data_file,
                std::vector<Fault>& all) {
  for (Fault& fault : faults) {
    if (std::ranges::any_of(
            condition, [&](const cases::Override& o) { return fault.where == "--set " + o.key; }))
      fault.where = fmt::format("{}, column {}", data_file, fault.where.substr(6));
    if (std::ranges::none_of(
            all, [&](const Fault& f) { return f.where == fault.where && f.what == fault.what; }))
      all.push_back(std::move(fault));
  }
}

/// The case under each condition. Throws InputError with the faults of all.
std::vector<TrialRuns> under_conditions(const fs::path& file, const Measurements& data,
                                        const std::string& data_file, const cases::Catalogue& known,
                                        const Overrides& set) {
  std::vector<TrialRuns> made;
  std::vector<Fault> wrong;
  for (const Overrides& condition : data.conditions) try {
      Overrides all = set;
      all.insert(all.end(), condition.begin(), condition.end());
      made.emplace_back(file, known, std::move(all), cases::ValueSource::fit);
      // Another corner of the ranges may be sound.
      add_faults(run_faults(made.back().at(DesignPoint(made.back().ranges().size(), 0.5), 0, 1)),
                 condition, data_file, wrong);
    } catch (const InputError& error) {
      add_faults(error.faults(), condition, data_file, wrong);
    }
  if (!wrong.empty()) throw InputError(std::move(wrong));
  return made;
}

std::vector<FreeParameter> parameters_of(const std::vector<cases::SweptKey>& ranges) {
  std::vector<FreeParameter> made;
  for (const cases::SweptKey& range : ranges)
    made.push_back({.name = range.key,
                    .least = parse_quantity(range.values[0]).value,
                    .most = parse_quantity(range.values[1]).value});
  return made;
}

/// Data of the goal: one for each measurement.
std::vector<Datum> data_of(const CalibrationJob& job) {
  std::vector<Datum> made;
  std::vector<std::string> names;  // of quantities with a scatter of their own
  for (const Measurement& m : job.data.values) {
    auto name = std::ranges::find(names, m.name());
    if (name == names.end()) name = names.insert(name, m.name());
    made.push_back({.outcome = job.outcome(m),
                    .value = m.value,
                    .error = m.error,
                    .quantity = static_cast<std::size_t>(name - names.begin())});
  }
  return made;
}

void check_quantities(const CalibrationJob& job) {
  std::vector<Fault> wrong;
  for (const Measurement& m : job.data.values) {
    if (m.what != MeasuredQuantity::of_run) continue;
    const RunQuantities there = run_quantities(job.conditions[m.condition].base());
    if (std::ranges::find(there, m.quantity.name, &RunQuantity::name) == there.end())
      add_faults({{fmt::format("{}:{}", job.data_file, m.line),
                   fmt::format("under this condition a run has no quantity {}", m.quantity.name),
                   "leave the cell empty, or change the condition", "no-such-quantity"}},
                 {}, job.data_file, wrong);
  }
  if (!wrong.empty()) throw InputError(std::move(wrong));
}

}  // namespace

double rebound_height(const cases::Case& mill_case, double fall) {
  const double speed = std::sqrt(2 * mill_case.gravity * fall);  // (cal.1)
  const double e = cases::bounce_table(mill_case).wall(0, 0).restitution.at(speed);
  return e * e * fall;  // (cal.2)
}

std::size_t CalibrationJob::outcome(const Measurement& measured) const {
  const auto at = std::ranges::find(quantities, quantity_of(measured));
  return measured.condition * quantities.size() + static_cast<std::size_t>(at - quantities.begin());
}

TrialRuns::Measure CalibrationJob::measure() const {
  return [this](const results::Outcome& outcome, const results::Replicate& replicate) {
    std::vector<double> values;
    for (const LabQuantity& q : quantities)
      values.push_back(q.fall > 0 ? rebound_height(outcome.mill_case, q.fall)
                                  : results::value_of(outcome, replicate, q.name));
    return values;
  };
}

bool calibrates(const fs::path& file, const Overrides& set) {
  return std::ranges::any_of(cases::fit_ranges(file), [&](const auto& range) {
    return cases::is_key_of_run(range.first) && !cases::gives_value(set, range.first);
  });
}

CalibrationJob calibration_job(const fs::path& file, const std::string& data_file,
                               const cases::Catalogue& known, const Overrides& set, int settings) {
  CalibrationJob job;
  job.data_file = data_file;
  const TrialRuns& unchanged =
      job.unchanged.emplace_back(file, known, set, cases::ValueSource::fit);
  check_keys(unchanged.base(), unchanged.ranges(), "[fit]");
  job.data = read_measurements(data_file, run_quantities(unchanged.base()));
  job.conditions = under_conditions(file, job.data, data_file, known, set);
  job.goal.parameters = parameters_of(unchanged.ranges());
  if (auto wrong = job_faults(job, set); !wrong.empty()) throw InputError(std::move(wrong));
  check_quantities(job);
  if (const int least = 4 * static_cast<int>(job.goal.parameters.size());
      settings != 0 && settings < least)
    throw InputError(Fault{"--settings",
                           fmt::format("{} settings are too few for {} keys of [fit]", settings,
                                       job.goal.parameters.size()),
                           fmt::format("give {} or more; usual are {}", least,
                                       usual_settings(job.goal.parameters.size())),
                           "out-of-range"});
  for (const Measurement& m : job.data.values)
    if (const LabQuantity q = quantity_of(m);
        std::ranges::find(job.quantities, q) == job.quantities.end())
      job.quantities.push_back(q);
  for (const LabQuantity& q : job.quantities)
    job.measure_name += q.fall > 0 ? fmt::format("{} {} ", q.name, q.fall) : q.name + " ";
  job.goal.data = data_of(job);
  job.goal.outcomes = job.conditions.size() * job.quantities.size();
  job.goal.settings = settings;
  job.goal.replicates = static_cast<int>(std::max<std::int64_t>(2, job.base().run.replicates));
  job.goal.seed = job.base().seed;
  return job;
}

std::vector<TrialResult> run_settings(const CalibrationJob& job,
                                      const std::vector<TrialRequest>& asked,
                                      const RunOptions& options, TrialStore& store,
                                      std::string_view version, results::NoticeCounts& notices) {
  const auto each =
      TrialRuns::run_each(job.conditions, asked, job.measure(), options, store, version);
  const std::vector<double> none(job.quantities.size(), std::numeric_limits<double>::quiet_NaN());
  std::vector<TrialResult> made(asked.size());
  for (std::size_t i = 0; i < asked.size(); ++i) {
    made[i].replicates.resize(static_cast<std::size_t>(asked[i].count));
    for (const std::vector<TrialResult>& of_condition : each) {
      const TrialResult& one = of_condition[i];
      results::count(notices, one.notices);
      if (!one.failure.empty()) made[i].failure = one.failure;
      for (std::size_t r = 0; r < made[i].replicates.size(); ++r) {
        const std::vector<double>& values = r < one.replicates.size() ? one.replicates[r] : none;
        made[i].replicates[r].insert(made[i].replicates[r].end(), values.begin(), values.end());
      }
    }
  }
  return made;
}

}  // namespace mahlwerk::campaign
