// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The guard of the soft engine against energy that appears or vanishes.
#include "mahlwerk/soft/energy_watch.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace mahlwerk::soft::energy_watch_test {
namespace {

/// A balance without a residual: 2 J, half of them in contacts.
scene::EnergyBalance even() {
  scene::EnergyBalance a;
  a.kinetic = a.elastic = 1;
  a.initial_energy = 2;
  return a;
}
/// With `more` [J] of kinetic energy from nowhere.
scene::EnergyBalance with(double more) {
  scene::EnergyBalance a = even();
  a.kinetic += more;
  return a;
}
/// Whether the guard finds a jump from `even` to `next`.
bool jumps(const scene::EnergyBalance& next, double wall_energy = 0, double least = 0) {
  EnergyWatch watch;
  watch.begin(even());
  return watch.update_and_test(next, wall_energy, least);
}

TEST(EnergyWatch, a_jump_is_more_than_a_tenth_of_the_energy) {
  EXPECT_FALSE(jumps(even()));
  EXPECT_FALSE(jumps(with(0.22))) << "a tenth of 2.22 J is 0.222 J";
  EXPECT_TRUE(jumps(with(0.225))) << "a tenth of 2.225 J is 0.2225 J";
  EXPECT_FALSE(jumps(with(-0.199))) << "energy that vanishes: a tenth of the 2 J that were there";
  EXPECT_TRUE(jumps(with(-0.201)));
  EXPECT_TRUE(jumps(with(NAN)));
}

TEST(EnergyWatch, energy_that_the_balance_explains_is_no_jump) {
  scene::EnergyBalance driven = with(5);
  driven.wall_work = 5;
  EXPECT_FALSE(jumps(driven));
  scene::EnergyBalance braked = with(-1);
  braked.lost_normal = 1;
  EXPECT_FALSE(jumps(braked));
}

TEST(EnergyWatch, the_energy_at_the_speed_of_the_wall_and_the_least_one_count) {
  EXPECT_TRUE(jumps(with(0.3)));
  EXPECT_FALSE(jumps(with(0.3), 0.75)) << "a tenth of 3.05 J";
  EXPECT_TRUE(jumps(with(0.3), 0.65)) << "a tenth of 2.95 J";
  EXPECT_FALSE(jumps(with(0.3), 0, 0.75));
  EXPECT_TRUE(jumps(with(0.3), 0, 0.65));
}

TEST(EnergyWatch, the_largest_energy_so_far_is_the_measure) {
  EnergyWatch watch;
  watch.begin(even());
  scene::EnergyBalance rest = even();
  rest.kinetic = rest.elastic = 0;
  rest.lost_normal = 2;
  EXPECT_FALSE(watch.update_and_test(rest, 0, 0));
  rest.kinetic = 0.19;
  EXPECT_FALSE(watch.update_and_test(rest, 0, 0)) << "a tenth of the 2 J at the start";
  rest.kinetic = 0.4;
  EXPECT_TRUE(watch.update_and_test(rest, 0, 0));
  watch.begin(even());
  EXPECT_FALSE(watch.update_and_test(with(0), 8, 0)) << "10 J with those of the wall";
  EXPECT_FALSE(watch.update_and_test(with(0.9), 0, 0)) << "a tenth of these 10 J";
}

TEST(EnergyWatch, a_slow_drift_is_no_jump) {
  EnergyWatch watch;
  watch.begin(even());
  for (int i = 1; i <= 20; ++i) EXPECT_FALSE(watch.update_and_test(with(0.1 * i), 0, 0));
}

}  // namespace
}  // namespace mahlwerk::soft::energy_watch_test
