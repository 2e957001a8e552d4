// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The event engine with the physics of a mill: steel balls of 1 mm in a box shaken at 20 Hz by 5
// mm, e = 0.9, friction 0.3, spin, gravity, the TC rule. For comparison, the speed of EDMD without
// any of these.
#include <fmt/format.h>

#include "charges.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::bench {
namespace {

double speed(int n, double packing) {
  constexpr double diameter = 1e-3, steel = 7850;
  const double side = side_of(n, packing, diameter);
  kinematics::Vibration motion;
  motion.frequency = 20;
  motion.amplitude = 0.005;
  const scene::Chamber mill{geometry::Box{side, side, side}, motion, {}, {0, 0, -9.81}};
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::tc;
  const auto engine = event::many_balls(mill, lattice(n, packing, diameter, steel, 0.2), rules,
                                        {1, 6, {0.9, 0, 0.3}});
  return collisions_per_second(*engine, 1e-4, 1.5);
}

}  // namespace

std::vector<Row> event() {
  std::vector<Row> rows;
  for (const Peers& peer : peers) {
    const std::string what =
        fmt::format("packing {:.2f}, {} balls", peer.packing, peer.n * peer.n * peer.n);
    const double found = speed(peer.n, peer.packing);
    rows.push_back({"event", what, "mahlwerk", "collisions_per_cpu_second", found});
    rows.push_back({"event", what, "EDMD elastic, quoted", "collisions_per_cpu_second", peer.edmd});
    rows.push_back({"event", what, "mahlwerk", "share_of_EDMD_elastic", found / peer.edmd});
  }
  return rows;
}

}  // namespace mahlwerk::bench
