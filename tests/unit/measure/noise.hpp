// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <numbers>

#include "mahlwerk/base/random.hpp"

// Noise of synthetic films, sounds and logs.
namespace mahlwerk::tests {

/// Normal noise whose correlation falls by `memory` from one number to the next.
class Noise {
 public:
  Noise(std::uint64_t seed, double deviation, double memory = 0, std::uint32_t stream = 0)
      : random_(seed, stream), deviation_(deviation), memory_(memory) {}

  double operator()() {
    const double radius = std::sqrt(-2 * std::log(random_.uniform()));
    const double normal = radius * std::cos(2 * std::numbers::pi * random_.uniform());
    last_ = memory_ * last_ + std::sqrt(1 - memory_ * memory_) * normal;
    return deviation_ * last_;
  }
  double uniform(double least, double most) { return random_.uniform(least, most); }

 private:
  Random random_;
  double deviation_, memory_, last_ = 0;
};

}  // namespace mahlwerk::tests
