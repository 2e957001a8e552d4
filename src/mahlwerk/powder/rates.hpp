// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/nip.hpp"
#include "mahlwerk/powder/sizes.hpp"
#include "mahlwerk/powder/stress.hpp"
#include "mahlwerk/powder/transition_matrix.hpp"

namespace mahlwerk::powder {

struct Process;

/// Levels of strength within a size class, strongest first, for models that track strength:
/// strength over median, and the share of fresh grains at each level. Other models have one level.
struct StrengthLevels {
  std::vector<double> strength{1}, fresh{1};
  int count() const { return static_cast<int>(strength.size()); }
};
StrengthLevels strength_levels(const AnyBreakage& breakage, int count = 20);

/// Captures by each stress in each bed. They do not depend on breakage, so that a fit computes them
/// once.
struct CaptureTable {
  std::vector<double> size;  ///< [m] grain size of each bed: one per class, or one for a mixed bed
  std::vector<Capture> captures;  ///< at index `bed * stresses + stress`
};
/// Computes the captures. `mean_size` [m] of the powder is used for a mixed bed only.
CaptureTable capture_table(const Process& process, const StressSpectrum& stresses,
                           const SizeGrid& grid, double mean_size);

/// Rate matrix [1/s] of the population balance (pbm.1), (pbm.2), for states `class * levels +
/// level`. Grains of the last class do not break.
RateMatrix rate_matrix(const Process& process, const StressSpectrum& stresses, const SizeGrid& grid,
                       const StrengthLevels& levels, const CaptureTable& table);

}  // namespace mahlwerk::powder
