// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/scene/grain_breakage.hpp"

#include <algorithm>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::scene {
namespace {

constexpr double lowest = 1e-4;  // [J/kg] middle of the first bin; the last one is at 2e10

}  // namespace

int GrainBreakage::bin_of(double energy) {
  const double place = 2 * math::log2(energy / lowest) + 0.5;
  return static_cast<int>(std::clamp(place, 0.0, energy_bins - 1.0));
}

double GrainBreakage::energy_of_bin(int bin) {
  return lowest * math::exp2(0.5 * bin);
}

}  // namespace mahlwerk::scene
