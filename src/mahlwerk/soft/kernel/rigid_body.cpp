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
      Vec<V> ex, ey, ez;
      axes_of(turned, ex, ey, ez);
      group.put(all.ex, ex), group.put(all.ey, ey), group.put(all.ez, ez);
      const Vec<V> momentum = group(all.predicted_momentum), factors = group(all.inverse_inertia);
      group.put(all.spin, factors.x * dot(ex, momentum) * ex + factors.y * dot(ey, momentum) * ey +
                              factors.z * dot(ez, momentum) * ez);
    }
  }
};

}  // namespace

TurnFreeBodies turn_free_bodies() {
  return Multiversioned<FreeTurnLoop, TurnFreeBodies>::best();
}

}  // namespace mahlwerk::soft
