// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "mahlwerk/powder/process.hpp"
#include "mahlwerk/powder/rates.hpp"

namespace mahlwerk::powder {

/// Population balance: the mass in each size class under breakage by collisions. Exact in time
/// where rates do not depend on the powder, as in beds by size. In a mixed bed, steps change the
/// mean size by at most 5 %, and rates are recomputed in each step (pbm.5).
class PopulationBalance {
 public:
  /// `feed`: mass share of each class of the grid. `known`: capture table of beds by size, if
  /// available.
  PopulationBalance(Process process, StressSpectrum stresses, SizeGrid grid,
                    const std::vector<double>& feed, const CaptureTable* known = nullptr);

  void advance(double time);           ///< by `time` [s] >= 0
  std::vector<double> shares() const;  ///< mass share of each size class
  const SizeGrid& grid() const { return grid_; }

 private:
  RateMatrix rates_at(double mean_size) const;
  void advance_mixed(double time);

  Process process_;
  StressSpectrum stresses_;
  SizeGrid grid_;
  StrengthLevels levels_;
  std::vector<double> states_;
  std::optional<RateMatrix> rates_;  // if they are constant
  std::optional<std::pair<double, Matrix>>
      transition_;  // last time step [s] and its transition matrix
};

}  // namespace mahlwerk::powder
