// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The elastic periodic fluid, the usual benchmark of event-driven codes: equal smooth spheres, e =
// 1, no gravity. The whole engine is measured, with records of all collisions and the energy
// balance.
#include <fmt/format.h>

#include <array>
#include <cmath>

#include "charges.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::bench {
namespace {

double speed(int n, double packing) {
  const double side = side_of(n, packing, 1);
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::none;
  const scene::Chamber box{geometry::PeriodicBox{side, side, side}, kinematics::Still{}, {}, {}};
  const auto engine =
      event::many_balls(box, lattice(n, packing, 1, 1, 2), rules, {1, 0, {1, 1, INFINITY}});
  return collisions_per_second(*engine, 0.02, 0.7);
}

}  // namespace

std::vector<Row> fluid() {
  std::vector<Row> rows;
  for (const double packing : {0.20, 0.49}) {
    std::array<double, 2> ends{};
    for (const Peers& peer : peers) {
      if (peer.packing != packing) continue;
      const std::string what =
          fmt::format("packing {:.2f}, {} balls", packing, peer.n * peer.n * peer.n);
      const double found = speed(peer.n, packing);
      ends[peer.n == 10 ? 0 : 1] = found;
      rows.push_back({"fluid", what, "mahlwerk", "collisions_per_cpu_second", found});
      rows.push_back({"fluid", what, "EDMD, quoted", "collisions_per_cpu_second", peer.edmd});
      rows.push_back({"fluid", what, "DynamO, quoted", "collisions_per_cpu_second", peer.dynamo});
    }
    rows.push_back({"fluid", fmt::format("packing {:.2f}, 1000 to 97336 balls", packing),
                    "mahlwerk", "exponent_of_cost_per_collision",
                    std::log(ends[0] / ends[1]) / std::log(97.336)});
  }
  return rows;
}

}  // namespace mahlwerk::bench
