// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/tc_rule.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "mahlwerk/base/random.hpp"
#include "statement.hpp"

namespace mahlwerk::event::tc_rule_test {
namespace {

using tests::states;
using tests::stays_below;

constexpr TcRule sustained{.contact_time = 1e-4, .friction = 0.3};

double from_decade(Random& random, double low, double high) {
  return std::pow(10, random.uniform(low, high));
}

TcRule::CollisionInput random_input(Random& random) {
  return {.mass = from_decade(random, -6, 0),
          .approach = from_decade(random, -12, 2),
          .slip = random.uniform(0, 1) < 0.1 ? 0 : from_decade(random, -12, 2),
          .since = random.uniform(0, 1) < 0.2 ? INFINITY : from_decade(random, -12, -2),
          .pressing_acceleration = from_decade(random, -1, 4),
          .stored = random.uniform(0, 1) < 0.5 ? 0 : from_decade(random, -20, 0)};
}

contact::BounceRule random_rule(Random& random) {
  const double edge = random.uniform(0, 1);
  const double e = edge < 0.1 ? 0 : edge < 0.2 ? 1 : random.uniform(0, 1);
  return {e, std::round(random.uniform(-1.5, 1.5)),
          random.uniform(0, 1) < 0.1 ? INFINITY : random.uniform(0, 1.5)};
}

TEST(TcRule, no_collision_gains_energy_beyond_what_is_stored) {
  Random random(7, 0);
  double most = -INFINITY;
  int draws = 0;
  for (int i = 0; i < 1'000'000; ++i) {
    const auto in = random_input(random);
    const auto out = sustained.collide(random_rule(random), in);
    const double energy =
        0.5 * in.mass * (in.approach * in.approach + in.slip * in.slip) + out.drawn;
    most = tests::max_or_nan(most, -(out.loss.normal + out.loss.tangential + out.drawn) / energy);
    ASSERT_GE(out.drawn, 0);
    ASSERT_LE(out.drawn, in.stored);
    draws += out.drawn > 0 ? 1 : 0;
  }
  EXPECT_GT(draws, 10'000);
  stays_below("largest gain over the energy of the collision", most, 8 * 0x1p-52,
              "man.4 to man.6: passive, up to a few roundings");
}

TEST(TcRule, what_is_drawn_is_what_the_bodies_gain) {
  // Sticking contact without sliding: the bodies gain the drawn energy and no more.
  const contact::BounceRule rule{0.5, 0, 0.3};
  const double u = 1e-6, stored = 1e-9;
  const auto out = sustained.collide(rule, {0.01, u, 0, 0, 9.81, stored});
  const double rebound = out.impulse.normal / 0.01 - u;
  states("gain [J]", 0.5 * 0.01 * (rebound * rebound - u * u), out.drawn, 1e-24, "man.6");
  states("drawn [J]", out.drawn, stored, 0, "the bounce wants more than there is");
}

TEST(TcRule, bodies_store_losses_as_far_as_there_is_room_and_give_no_more) {
  double one = 0, other = 0;
  StoredEnergy both(one, 3, other, 1);
  const auto settle = [&](contact::Loss loss, double drawn) {
    TcRule::Result collision{.impulse = {}, .loss = loss, .drawn = drawn};
    both.update(collision);
    return collision;
  };
  const auto first = settle({4, 0}, 0);
  EXPECT_EQ(one, 2);
  EXPECT_EQ(other, 1);
  EXPECT_EQ(first.stored_change, 3);
  EXPECT_EQ(first.loss.normal, 1) << "the rest is dissipated";
  EXPECT_EQ(settle({0, 4}, 0).loss.tangential, 3);
  EXPECT_EQ(one, 3);
  const auto drawn = settle({-3.5, 0}, 3.5);
  EXPECT_EQ(both.sum(), 0.5);
  EXPECT_EQ(drawn.loss.normal, 0) << "drawn energy was not dissipated before";
  EXPECT_EQ(settle({-0.5, 0}, 0.5).stored_change, -0.5);
  EXPECT_EQ(both.sum(), 0);
}

TEST(TcRule, every_collision_ends_with_bodies_that_part) {
  Random random(8, 0);
  for (int i = 0; i < 100'000; ++i) {
    const auto in = random_input(random);
    const auto out = sustained.collide(random_rule(random), in);
    const double rebound = out.impulse.normal / in.mass - in.approach;
    const double min_rebound = sustained.min_rebound_speed(in.since, in.pressing_acceleration);
    const double rounding = 4 * 0x1p-52 * in.approach;
    ASSERT_GE(rebound + rounding, std::min(in.approach, min_rebound) * (1 - 4 * 0x1p-52))
        << "u_n " << in.approach << " m/s, w " << min_rebound << " m/s";
  }
}

TEST(TcRule, friction_stays_within_coulombs_limit) {
  Random random(9, 0);
  for (int i = 0; i < 100'000; ++i) {
    const auto in = random_input(random);
    contact::BounceRule rule = random_rule(random);
    rule.friction = random.uniform(0, 1);
    const auto out = sustained.collide(rule, in);
    ASSERT_LE(out.impulse.tangential, rule.friction * out.impulse.normal * (1 + 1e-15));
    if (rule.tangential_restitution == 1) {
      ASSERT_EQ(out.impulse.tangential, 0) << "smooth";
    }
  }
}

TEST(TcRule, sliding_returns_to_the_rebound_all_that_it_dissipates) {
  // Crowded (since = 0), so that w is not the limit. u_t is far above 7/2 mu u_n, so that the
  // contact slides.
  const contact::BounceRule rule{0.5, 0, 0.3};
  const auto out = sustained.collide(rule, {0.01, 1e-4, 5e-4, 0, 9.81});
  EXPECT_GT(out.impulse.normal, 2 * 0.01 * 1e-4) << "more than elastic along the normal";
  states("loss of both directions [J]", out.loss.normal + out.loss.tangential, 0, 1e-25, "man.5");
}

TEST(TcRule, a_hit_within_the_contact_time_loses_what_restitution_says) {
  const contact::BounceRule rule{0.5, 1, 0};
  const auto out = sustained.collide(rule, {2, 10, 0, 1e-6, 9.81});
  states("loss [J]", out.loss.normal, 0.5 * 2 * 100 * (1 - 0.25), 1e-12, "evt.8: a true hit");
  EXPECT_FALSE(out.raised);
  EXPECT_NEAR(out.withheld, 0, 1e-12);
}

TEST(TcRule, what_a_bounce_withholds_is_counted) {
  const contact::BounceRule rule{0.5, 1, 0};
  const double u = 1e-4;  // [m/s] below a t_c/2
  const auto out = sustained.collide(rule, {2, u, 0, INFINITY, 9.81});
  EXPECT_TRUE(out.raised);
  states("withheld [J]", out.withheld, 0.5 * 2 * u * u * (1 - 0.25), 1e-22, "man.4");
}

}  // namespace
}  // namespace mahlwerk::event::tc_rule_test
