// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/soft/kernel/rigid_body.hpp"

namespace mahlwerk::soft {
namespace {

struct FreeTurnLoop {
  template <int width>
  [[gnu::always_inline]] static void run(FreeBodies& all) {
    using V = Register<width>;
    for (int first = 0; first < lanes; first += width) {
      const LaneGroup<V> group{first};
      OrientationOf<Lanes>& q = all.orientation;
      const auto turned = turned_freely<V>({group(q.w), group(q.x), group(q.y), group(q.z)},
                                           group(all.momentum), group(all.rate));
      group.put(q.w, turned.w), group.put(q.x, turned.x);
      group.put(q.y, turned.y), group.put(q.z, turned.z);
    }
  }
};

}  // namespace

TurnFreeBodies turn_free_bodies() {
  return Multiversioned<FreeTurnLoop, TurnFreeBodies>::best();
}

}  // namespace mahlwerk::soft
