// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/kernel/isa.hpp"

namespace mahlwerk::soft {
namespace {

struct Sought {
  const BallRecord* rows;
  std::span<const NeighbourPair> pairs;
  const Vec3& periods;
  std::span<double> gaps;
};

template <bool avx512>
[[gnu::always_inline]] inline void find(const Sought& s) {
  const bool folds =
      std::isfinite(s.periods.x) || std::isfinite(s.periods.y) || std::isfinite(s.periods.z);
  for (std::size_t k = 0; k < s.pairs.size(); k += lanes) {
    const std::size_t count = std::min<std::size_t>(lanes, s.pairs.size() - k);
    Apart a = apart<avx512>(s.rows, s.pairs.data() + k, count);
    if (folds) to_nearest(a.centres, s.periods);
    const Lanes gap = root(dot(a.centres, a.centres)) - a.touch;
    for (std::size_t l = 0; l < count; ++l) s.gaps[k + l] = gap[static_cast<int>(l)];
  }
}

#ifdef MAHLWERK_AVX512
[[gnu::target("avx512f,avx512dq,avx512vl"), gnu::flatten]] void find_avx512(const Sought& s) {
  find<true>(s);
}
#endif

}  // namespace

void find_gaps(const BallRecord* rows, std::span<const NeighbourPair> pairs, const Vec3& periods,
               std::span<double> gaps) {
  const Sought sought{rows, pairs, periods, gaps};
#ifdef MAHLWERK_AVX512
  if (isa() == Isa::avx512) return find_avx512(sought);
#endif
  find<false>(sought);
}

}  // namespace mahlwerk::soft
