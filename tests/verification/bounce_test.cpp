// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// One collision by the corrected rule of Chen et al. 2016, and by Walton's rule.
#include <gtest/gtest.h>

#include <algorithm>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::bounce_test {
namespace {

/// Throws a ball onto the floor of a wide box at rest without gravity. Returns its state after one
/// bounce.
scene::Ball after_one_bounce(const contact::BounceRule& rule, const Vec3& velocity,
                             const Vec3& spin, scene::Collision* seen = nullptr) {
  const scene::Chamber still{geometry::Cylinder{2, 2}, kinematics::Still{}, {}, {0, 0, 0}};
  event::Rules rules;
  rules.bounce = rule;
  const auto engine =
      event::one_ball(still, ball_a({0, 0, -1 + 0.004 + 1e-3}, velocity, spin), rules);
  Recorder recorder;
  engine->advance(1.5e-3 / -velocity.z, recorder);
  EXPECT_EQ(recorder.all.size(), 1U);
  if (seen != nullptr) *seen = recorder.all.at(0);
  return engine->balls().front();
}

TEST(Bounce, sliding_ball_that_sticks_keeps_five_sevenths_and_rolls_forward) {
  const scene::Ball b = after_one_bounce({0.5, 0, INFINITY}, {1, 0, -1}, {});
  states("v_x after [m/s]", b.velocity.x, 5.0 / 7, 1e-15, "seed 0 eq. 8 corrected, S0-8");
  states("w_y after [rad/s]", b.spin.y, 5.0 / (7 * 0.004), 1e-12, "seed 0 eq. 9 corrected, S0-9");
  states("v_z after [m/s]", b.velocity.z, 0.5, 1e-15, "e_n = 0.5");
}

TEST(Bounce, elastic_head_on_reverses_the_velocity) {
  const scene::Ball b = after_one_bounce({1, 1, INFINITY}, {0, 0, -2}, {});
  states("v_z after [m/s]", b.velocity.z, 2, 1e-15,
         "S0-8: the printed form does it only for e = 2");
}

TEST(Bounce, slip_is_reduced_to_e_t_of_itself) {
  for (const double e_t : {1.0, 0.9, 0.3, 0.0, -0.4, -1.0}) {
    const Vec3 velocity{0.7, -0.4, -1.2}, spin{30, -50, 80};
    const scene::Ball b = after_one_bounce({0.9, e_t, INFINITY}, velocity, spin);
    const Vec3 n{0, 0, -1};
    const auto slip = [&](const Vec3& v, const Vec3& w) {
      return tangential_part(v + 0.004 * cross(w, n), n);
    };
    states("slip after, e_t = " + std::to_string(e_t) + " [m/s]",
           norm(slip(b.velocity, b.spin) - e_t * slip(velocity, spin)), 0, 1e-15, "physics 2.1");
    states("spin about the normal [rad/s]", b.spin.z, spin.z, 0, "no torque about it");
  }
}

TEST(Bounce, walton_slides_above_the_transition_and_sticks_below) {
  const double e = 0.8, mu = 0.2, beta0 = 0.4;
  const double transition = 3.5 * mu * (1 + e) / (1 + beta0);
  for (const double steepness : {0.2, 0.9, 1.1, 5.0}) {
    const double slip = steepness * transition;  // at u_n = 1 m/s
    const scene::Ball b = after_one_bounce({e, -beta0, mu}, {slip, 0, -1}, {});
    const double left = b.velocity.x - 0.004 * b.spin.y;
    const double expected = steepness < 1 ? -beta0 : 1 - 3.5 * mu * (1 + e) / slip;
    states("e_t found at " + std::to_string(steepness) + " of the transition", left / slip,
           expected, 2e-15, "physics 2.2, sliding branch");
  }
}

TEST(Bounce, record_says_what_happened) {
  scene::Collision c;
  after_one_bounce({0.9, 0.9, INFINITY}, {1.5, 0, -2}, {0, 100, 0}, &c);
  const double m = ball_a().mass(), slip = 1.5 - 0.004 * 100;
  EXPECT_EQ(~c.other, 1);  // the bottom
  states("approach [m/s]", c.approach, 2, 1e-15, "u_n");
  states("slip [m/s]", c.slip, slip, 1e-15, "|u_t|, spin included");
  states("glide [m/s]", c.glide, 1.5, 1e-15, "spin left out");
  states("energy at the contact point [J]", c.energy_contact_point(), 0.5 * m * (4 + slip * slip),
         1e-18, "physics 2.5");
  states("energy of the centres [J]", c.energy_centre(), 0.5 * m * (4 + 2.25), 1e-18,
         "physics 2.5");
  states("dissipated [J]", c.lost(),
         0.5 * m * ((1 - 0.81) * 4 + 2.0 / 7 * (1 - 0.81) * slip * slip), 1e-18, "physics 2.5");
  states("impulse [N s]", c.impulse, m * 1.9 * 2, 1e-18, "m (1+e) u_n");
}

TEST(Bounce, no_collision_makes_energy_whatever_the_angle) {
  Random random(5, 0);
  double least = 1;
  for (int i = 0; i < 200000; ++i) {
    const contact::BounceRule rule{random.uniform(), random.uniform(-1, 1),
                                   i % 2 == 0 ? INFINITY : random.uniform(0, 2)};
    const double approach = std::pow(10, random.uniform(-6, 1)),
                 slip = std::pow(10, random.uniform(-6, 1));
    const contact::Loss l =
        contact::loss(contact::bounce(rule, 1, approach, slip), 1, approach, slip);
    least = std::min({least, l.normal / (approach * approach), l.tangential / (slip * slip)});
  }
  stays_below("largest gain over the energy at hand", -least, 1e-16, "rounding");
}

}  // namespace
}  // namespace mahlwerk::tests::bounce_test
