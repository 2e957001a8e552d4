// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The elastic periodic fluid, the usual benchmark of event-driven codes: equal smooth spheres, e =
// 1, no gravity. The whole engine is measured, with records of all collisions and the energy
// balance. Another program is timed in the same turns if MAHLWERK_RIVAL names it (rival.hpp).
#include <cmath>
#include <map>
#include <optional>

#include "charges.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "rival.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int turns = 5;

EngineTurns elastic_fluid(const ChargeCase& charge) {
  const double side = side_of(charge.n, charge.packing, 1);
  event::Rules rules;
  rules.sustained_mode = event::SustainedContactMode::none;
  const scene::Chamber box{geometry::PeriodicBox{side, side, side}, kinematics::Still{}, {}, {}};
  return {event::many_balls(box, lattice(charge.n, charge.packing, 1, 1, 2), rules,
                            {1, 0, {1, 1, INFINITY}}),
          0.02, 0.7};
}

void add(std::vector<Row>& rows, const ChargeCase& charge, const char* code, const char* metric,
         const std::vector<double>& values) {
  const Spread s = spread(values);
  rows.push_back({"fluid", charge.name(), code, metric, s.middle, s.least, s.most});
}

/// Times both programs in alternating turns; a turn's ratio is that of its two speeds.
double compare(const ChargeCase& charge, const std::optional<Rival>& rival,
               std::vector<Row>& rows) {
  EngineTurns engine = elastic_fluid(charge);
  std::vector<double> own, other, ratio;
  for (int i = 0; i < turns; ++i) {
    own.push_back(engine.collisions_per_second());
    if (!rival) continue;
    other.push_back(rival->collisions_per_second(charge.packing, charge.balls()));
    ratio.push_back(own.back() / other.back());
  }
  add(rows, charge, "mahlwerk", "collisions_per_cpu_second", own);
  if (rival) {
    add(rows, charge, "rival", "collisions_per_cpu_second", other);
    add(rows, charge, "mahlwerk", "speed_over_rival", ratio);
  }
  return median(own);
}

}  // namespace

std::vector<Row> fluid() {
  const std::optional<Rival> rival = Rival::from_environment();
  std::vector<Row> rows;
  std::map<double, std::map<int, double>> speeds;  // by packing and number of balls
  for (const ChargeCase& charge : charge_cases)
    speeds[charge.packing][charge.balls()] = compare(charge, rival, rows);
  for (const auto& [packing, by_count] : speeds) {
    const auto [fewest, fast] = *by_count.begin();
    const auto [most, slow] = *by_count.rbegin();
    rows.push_back({"fluid", fmt::format("packing {:.2f}, {} to {} balls", packing, fewest, most),
                    "mahlwerk", "exponent_of_cost_per_collision",
                    std::log(fast / slow) / std::log(static_cast<double>(most) / fewest)});
  }
  return rows;
}

}  // namespace mahlwerk::bench
