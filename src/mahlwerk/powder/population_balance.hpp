// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mahlwerk/powder/process.hpp"
#include "mahlwerk/powder/rates.hpp"

namespace mahlwerk::powder {

/// The population balance: the mass in each class of size as collisions break it down. Exact in
/// time where rates do not hang on the powder, as in beds by size; in a mixed bed they are taken
/// anew whenever its mean size has changed by 5 % (pbm.5).
class PopulationBalance {
 public:
  /// `feed`: shares of each class of the grid. `known`: its beds by size, where they are at hand.
  PopulationBalance(Process process, StressSpectrum stresses, SizeGrid grid,
                    const std::vector<double>& feed, const CaptureTable* known = nullptr);

  void advance(double time);           ///< [s] >= 0 further
  std::vector<double> shares() const;  ///< of each class of size
  const SizeGrid& grid() const { return grid_; }

 private:
  RateMatrix rates_at(double mean_size) const;
  void advance_mixed(double time);

  Process process_;
  StressSpectrum stresses_;
  SizeGrid grid_;
  StrengthLevels levels_;
  std::vector<double> states_;
  std::optional<RateMatrix> rates_;  // where they stay as they are
  std::optional<std::pair<double, Matrix>>
      transition_;  // the last time asked for [s], and its step
};

}  // namespace mahlwerk::powder
