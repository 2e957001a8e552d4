// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>
#include <string>
#include <vector>

#include "mahlwerk/campaign/fit/measurements.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"

// What a fit and a calibration have in common: a case, measurements, and what the model gives.
namespace mahlwerk::campaign {

/// A measurement beside the model with the estimated parameters, in SI units.
struct PredictedMeasurement : Measurement {
  observe::IntervalEstimate predicted = {};  ///< of a calibration with its 95 % interval (cal.8)
  double residual = std::numeric_limits<double>::quiet_NaN();  ///< of a fit
  observe::Estimate simulated = {};  ///< of a calibration: runs at its centre, with new seeds
};

struct MeasurementStudy {
  std::string title = {}, case_file = {}, data_file = {};
  std::vector<std::string> conditions =
      {};  ///< "mill.frequency = 16 Hz"; empty: the case unchanged
  std::vector<PredictedMeasurement> points = {};
  results::NoticeCounts notices = {};  ///< of the runs
  bool errors_known = false;           ///< of the measurements

  /// Name of a condition in a sentence; "the case" for the case unchanged.
  std::string condition_name(std::size_t condition) const;
};

/// Title and files of a study, and the names of the conditions of its data.
void describe(MeasurementStudy& study, const cases::Case& base, const std::string& data_file,
              const Measurements& data);

}  // namespace mahlwerk::campaign
