// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "mahlwerk/campaign/fit/least_squares.hpp"
#include "mahlwerk/campaign/fit/measurements.hpp"
#include "mahlwerk/powder/size_evolution.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Whether a measurement is of the sizes of the powder.
bool of_sizes(MeasuredQuantity what);

/// Predicts measurements with the powder models from the collisions of mills that are simulated
/// once.
class Predictor {
 public:
  /// `mills`: one per condition, kept by reference; each has a replicate that counted.
  /// `measurements` have times no longer than their case mills. Uses the mean of all replicates, or
  /// replicate `only`.
  Predictor(const std::vector<results::Outcome>& mills, std::vector<FreeParameter> parameters,
            std::vector<Measurement> measurements, int threads = 0,
            std::optional<std::size_t> only = std::nullopt);

  /// The predicted value of each measurement for these parameter values; NaN where the models give
  /// none.
  std::vector<double> operator()(const std::vector<double>& values) const;

 private:
  struct Mill {
    const results::Outcome* outcome;
    std::vector<const results::Replicate*> replicates;
    powder::StressSpectrum stresses;
    std::optional<powder::CaptureTable> beds;  ///< if no free parameter changes them
    bool grinds = false;                       ///< has measurements of sizes
    std::vector<std::size_t> measurements;     ///< indices in measurements_
  };
  void predict(const Mill& mill, const std::vector<double>& values,
               std::vector<double>& predicted) const;

  std::vector<FreeParameter> parameters_;
  std::vector<Measurement> measurements_;
  std::vector<Mill> mills_;
  int threads_;
};

}  // namespace mahlwerk::campaign
