// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/kernel/periodic.hpp"

namespace mahlwerk::soft {
namespace {

using FindGaps = void (*)(const BallRecord*, std::span<const NeighbourPair>, const Vec3& periods,
                          std::span<double> gaps);
struct GapLoop {
  template <int width>
  [[gnu::always_inline]] static void run(const BallRecord* rows,
                                         std::span<const NeighbourPair> pairs, const Vec3& periods,
                                         std::span<double> gaps) {
    const bool periodic = is_periodic(periods);
    using V = Register<width>;
    for (std::size_t k = 0; k < pairs.size(); k += width) {
      const std::size_t count = std::min<std::size_t>(width, pairs.size() - k);
      PairSeparation<V> a = pair_separations<V>(rows, pairs.data() + k, count);
      if (periodic) a.centres = nearest_image<V>(a.centres, periods);
      const V gap = sqrt(dot(a.centres, a.centres)) - a.touch;
      for (std::size_t l = 0; l < count; ++l) gaps[k + l] = gap[static_cast<int>(l)];
    }
  }
};

}  // namespace

void find_gaps(const BallRecord* rows, std::span<const NeighbourPair> pairs, const Vec3& periods,
               std::span<double> gaps) {
  Multiversioned<GapLoop, FindGaps>::best()(rows, pairs, periods, gaps);
}

}  // namespace mahlwerk::soft
