// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk {

/// Counter-based random number generator (Philox 4x32-10, Salmon et al. 2011). The n-th number of a
/// stream depends only on (seed, stream, n), so results do not depend on threads or order.
class Random {
 public:
  Random(std::uint64_t seed, std::uint32_t stream) : seed_(seed), stream_(stream) {}

  double uniform();  ///< in (0, 1)
  double uniform(double least, double most) { return least + (most - least) * uniform(); }
  Vec3 direction();  ///< uniform on the unit sphere

 private:
  std::uint64_t seed_;
  std::uint32_t stream_;
  std::uint64_t drawn_ = 0;
};

}  // namespace mahlwerk
