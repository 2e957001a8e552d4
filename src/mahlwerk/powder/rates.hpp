// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/powder/flow.hpp"
#include "mahlwerk/powder/process.hpp"
#include "mahlwerk/powder/sizes.hpp"

namespace mahlwerk::powder {

/// Levels of strength within a class of size, strongest first, for models that remember: strength
/// over median, and the share of fresh grains at each. One level for all others.
struct Levels {
  std::vector<double> strength{1}, fresh{1};
  int count() const { return static_cast<int>(strength.size()); }
};
Levels levels(const AnyBreakage& breakage, int count = 20);

/// What collisions do to the mass of each state (pbm.1), (pbm.2): state `class * levels + level`.
/// Grains of the last class do not break. `mean_size` [m] is that of the powder, for a mixed bed.
Rates rates(const Process& process, const StressSpectrum& stresses, const SizeGrid& grid,
            const Levels& levels, double mean_size);

}  // namespace mahlwerk::powder
