// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/base/lanes.hpp"

namespace mahlwerk::geometry {

/// Positions of a register of points relative to one face each (geometry::Gap). Simple shapes have
/// `gaps(face, p)`, which returns the bits of gap() in each lane; `face` holds numbers of faces.
template <class V>
struct LaneGap {
  V distance;     ///< [m]
  Vec<V> inward;  ///< unit normal
};

/// The unit vectors against `e`, of length `r`; `other` where r is 0.
template <class V>
[[gnu::always_inline]] inline Vec<V> inward_from_core(const Vec<V>& e, const V& r,
                                                      const Vec<V>& other) {
  return select<V>(less(V{}, r), {-e.x / r, -e.y / r, -e.z / r}, other);
}

}  // namespace mahlwerk::geometry
