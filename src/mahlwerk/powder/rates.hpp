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

/// Levels of strength within a class of size, strongest first, for models that remember: strength
/// over median, and the share of fresh grains at each. One level for all others.
struct StrengthLevels {
  std::vector<double> strength{1}, fresh{1};
  int count() const { return static_cast<int>(strength.size()); }
};
StrengthLevels strength_levels(const AnyBreakage& breakage, int count = 20);

/// The beds that grains are caught in, and what each stress catches in each. They do not hang on
/// how grains break, so a fit makes them once.
struct CaptureTable {
  std::vector<double> size;  ///< [m] of the grains: for each class, or one for all in a mixed bed
  std::vector<Capture> captures;  ///< `bed * stresses + stress`
};
/// `mean_size` [m] of the powder matters to a mixed bed only.
CaptureTable capture_table(const Process& process, const StressSpectrum& stresses,
                           const SizeGrid& grid, double mean_size);

/// What collisions do to the mass of each state (pbm.1), (pbm.2): state `class * levels + level`.
/// Grains of the last class do not break.
RateMatrix rate_matrix(const Process& process, const StressSpectrum& stresses, const SizeGrid& grid,
                       const StrengthLevels& levels, const CaptureTable& table);

}  // namespace mahlwerk::powder
