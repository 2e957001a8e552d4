// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Beds of balls in which each ball has many contacts.
#include <gtest/gtest.h>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::bed_test {
namespace {

using contact::HertzMindlin;
using contact::Rolling;

/// Balls of 1.6 mm in a box of 0.02 m, a dozen layers, that fall and come to rest.
std::unique_ptr<scene::Engine> bed(Rolling rule) {
  Random random(1, 0);
  std::vector<scene::Ball> balls;
  constexpr double radius = 0.0008, pitch = 0.00165;
  for (int x = -4; x <= 4; ++x)
    for (int y = -4; y <= 4; ++y)
      for (int z = -5; z <= 5; ++z)
        balls.push_back({radius, 4930, pitch * Vec3{1.0 * x, 1.0 * y, 1.0 * z},
                         0.05 * random.direction(), 20 * random.direction()});
  contact::Pair pair = pair_of({1e9, 0.2}, {1e9, 0.2}, 0.2, 0.5);
  pair.rolling_friction = 0.05;
  soft::Settings rules{of_law(HertzMindlin{}, rule), 8e-7, false};
  return soft::make_engine(
      {geometry::Box{0.015, 0.015, 0.02}, kinematics::Still{}, {}, {0, 0, -2000}}, balls, rules,
      contact::PairTable(1, geometry::Box::faces, pair), 0);
}

TEST(Bed, rolling_resistance_of_many_contacts_puts_no_energy_in) {
  const auto balance = [](Rolling rule) {
    const auto engine = bed(rule);
    Recorder none;
    engine->advance(0.01, none);
    const scene::EnergyBalance a = engine->energy_balance();
    return std::abs(a.residual()) / a.lost();
  };
  // Residual due to the time step, without rolling resistance. It is seven times as large if each
  // contact of cdt may stop a ball's rolling within two steps.
  const double without = balance(Rolling::none);
  stays_below("none: balance over what was lost", without, 2e-3,
              "a fortieth of a contact, squared");
  stays_below("cdt", balance(Rolling::cdt), 2 * without, "twice that without");
  stays_below("epsd", balance(Rolling::epsd), 2 * without, "twice that without");
}

}  // namespace
}  // namespace mahlwerk::tests::bed_test
