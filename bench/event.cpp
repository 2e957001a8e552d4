// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The event engine with the physics of a mill: steel balls of 1 mm in a box shaken at 20 Hz by 5
// mm, e = 0.9, friction 0.3, spin, gravity, the TC rule.
#include "charges.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int turns = 5;

EngineTurns shaken_box(const ChargeCase& charge) {
  constexpr double diameter = 1e-3, steel = 7850;
  const double side = side_of(charge.n, charge.packing, diameter);
  kinematics::Vibration motion;
  motion.frequency = 20;
  motion.amplitude = 0.005;
  const scene::Chamber mill{geometry::Box{side, side, side}, motion, {}, {0, 0, -9.81}};
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::tc;
  return {event::many_balls(mill, lattice(charge.n, charge.packing, diameter, steel, 0.2), rules,
                            {1, 6, {0.9, 0, 0.3}}),
          1e-4, 1.5};
}

}  // namespace

std::vector<Row> event() {
  std::vector<Row> rows;
  for (const ChargeCase& charge : charge_cases) {
    EngineTurns engine = shaken_box(charge);
    std::vector<double> speeds;
    for (int i = 0; i < turns; ++i) speeds.push_back(engine.collisions_per_second());
    const Spread s = spread(speeds);
    rows.push_back({"event", charge.name(), "mahlwerk", "collisions_per_cpu_second", s.middle,
                    s.least, s.most});
  }
  return rows;
}

}  // namespace mahlwerk::bench
