// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <vector>

#include "mahlwerk/campaign/calibrate/calibration.hpp"
#include "mahlwerk/campaign/search/outcome_emulator.hpp"

namespace mahlwerk::campaign {

/// Emulators of all outcomes that have data; the others are empty.
std::vector<std::optional<OutcomeEmulator>> emulators(const CalibrationGoal& goal,
                                                      const std::vector<Trial>& trials);

/// Probability of the data as a function of the parameters (cal.3). A point has the positions of
/// the parameters, then those of the unknown scatters in their range (cal.4).
class Likelihood {
 public:
  /// Keeps references to its arguments. `inflation` >= 1: factor on the known errors.
  Likelihood(const CalibrationGoal& goal,
             const std::vector<std::optional<OutcomeEmulator>>& emulators, double inflation = 1);

  std::size_t coordinates() const { return goal_.parameters.size() + scatters_; }
  double log_at(const std::vector<double>& point) const;
  /// Sum of the squares of residuals in units of errors and emulators together (cal.6).
  double chi_square(const std::vector<double>& point) const;
  /// Variance of the emulator of a datum's outcome over that variance and the datum's own.
  double emulator_share(std::size_t datum, const std::vector<double>& point) const;
  /// Relative scatter of a quantity at a point.
  double scatter(std::size_t quantity, const std::vector<double>& point) const;

 private:
  struct Group {  // data of one outcome, which share its emulator
    std::size_t outcome;
    std::vector<std::size_t> data;
  };
  struct Term {
    double quadratic, log_determinant;
  };
  double deviation(const Datum& datum, const std::vector<double>& point) const;
  Term term(const Group& group, const std::vector<double>& point) const;

  const CalibrationGoal& goal_;
  const std::vector<std::optional<OutcomeEmulator>>& emulators_;
  double inflation_;
  std::size_t scatters_ = 0;
  std::vector<Group> groups_;
  std::vector<double> scale_;  // of a quantity: the mean size of its data
};

}  // namespace mahlwerk::campaign
