// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/campaign/calibrate/calibration.hpp"
#include "mahlwerk/campaign/fit/measurement_study.hpp"
#include "mahlwerk/campaign/search/trial_runs.hpp"

// A case with measurements on the mill, and the runs that predict them.
namespace mahlwerk::campaign {

/// A measured quantity, of any condition.
struct LabQuantity {
  std::string name, unit;
  double fall = 0;  ///< [m] of a rebound; else 0
  bool operator==(const LabQuantity&) const = default;
};

struct CalibrationJob {
  std::string data_file;
  Measurements data;
  std::vector<TrialRuns> unchanged;     ///< one: the case itself
  std::vector<TrialRuns> conditions;    ///< the case under each condition of the data
  std::vector<LabQuantity> quantities;  ///< outcomes of a run; those of all conditions are listed
                                        ///< condition by condition
  CalibrationGoal goal;
  std::string measure_name;  ///< identifies measure() in a TrialStore

  const cases::Case& base() const { return unchanged.front().base(); }
  std::size_t outcome(const Measurement& measured) const;  ///< its index
  TrialRuns::Measure measure() const;
};

/// Whether `mahlwerk fit` calibrates this case: [fit] has a key of the mill (is_key_of_run) that
/// `set` does not give. Throws InputError.
bool calibrates(const std::filesystem::path& file, const std::vector<cases::Override>& set);

/// Reads a case file with [fit] and a table of measurements. `settings` 0: as many as usual. Throws
/// InputError with the faults of all conditions.
CalibrationJob calibration_job(const std::filesystem::path& file, const std::string& data_file,
                               const cases::Catalogue& known,
                               const std::vector<cases::Override>& set, int settings = 0);

/// Runs settings under all conditions, with all outcomes of a setting in one list. Adds the notices
/// of the runs to `notices`.
std::vector<TrialResult> run_settings(const CalibrationJob& job,
                                      const std::vector<TrialRequest>& asked,
                                      const RunOptions& options, TrialStore& store,
                                      std::string_view version, results::NoticeCounts& notices);

struct Calibration : MeasurementStudy {
  CalibrationResult result = {};  ///< values and ranges in the units of the case
  std::string condition_key = {},
              condition_unit = {};            ///< the only key that varies, if it is a number
  std::vector<double> condition_values = {};  ///< its values
  int runs = 0;

  double emulator_error() const;  ///< largest leave-one-out error of an emulator, by spread
};

/// Calibrates the keys of the job by runs of its settings under all conditions, and runs the case
/// at the centre of the posterior with new seeds. Throws as `calibrate` of a goal does.
Calibration calibrate(CalibrationJob& job, const Simulation& run,
                      const CalibrationOptions& options);

/// The case with the most central draw as values, and the others as [uncertainty].
cases::Case calibrated_case(const CalibrationJob& job, const Calibration& found);

/// [m] Height to which a ball of the first set rebounds from the first face of the jar (cal.2).
double rebound_height(const cases::Case& mill_case, double fall);

}  // namespace mahlwerk::campaign
