// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Balls that leave the jar and enter it again: nothing is lost in number, mass and energy (flo.2,
// flo.3), and the bits do not depend on threads and cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "same_bits.hpp"
#include "statement.hpp"
#include "verification/soft/flowing.hpp"

namespace mahlwerk::tests::flow_test {
namespace {

using namespace flowing;

/// The worst residuals of number, mass and energy over a run.
void books_close(const char* what, const scene::Chamber& jar, Feed feed, double least_left) {
  const std::vector<scene::Ball> start = grains(400, 0.001);
  const auto run = engine(jar, start, flow(feed));
  const scene::EnergyBalance first = run->energy_balance();
  FlowObserver seen;
  double number = 0, mass = 0, energy = 0, turned_over = 0;
  for (int k = 1; k <= 100; ++k) {
    run->advance(0.002 * k, seen);
    const auto balls = run->balls();
    const auto inside =
        static_cast<double>(std::ranges::count(balls, false, &scene::Ball::outside));
    number = std::max(number, std::abs(inside - seen.count(true) + seen.count(false) - 400));
    mass = max_or_nan(mass, std::abs(mass_of(balls, false) - seen.mass(true) + seen.mass(false) -
                                     mass_of(start, false)));
    const scene::EnergyBalance now = run->energy_balance();
    energy = max_or_nan(energy, std::abs(now.residual() - first.residual()));
    turned_over = now.lost();
  }
  std::printf("    %s: %.0f left, %.0f entered\n", what, seen.count(false), seen.count(true));
  EXPECT_GT(seen.count(false), least_left);
  states("balls that are missing", number, 0, 0, "inside + left - entered = at the start (flo.2)");
  stays_below("mass that is missing, relative", mass / mass_of(start, false), 1e-12,
              "rounding of the sums (flo.2)");
  stays_below("energy that is missing over the dissipated", energy / turned_over,
              3 * error_without_flow(jar), "three times that without flow (flo.3)");
  double lost = 0;
  for (const scene::Collision& c : seen.hits) lost += c.lost();
  const scene::EnergyBalance now = run->energy_balance();
  stays_below("records and open contacts against the balance, relative",
              std::abs(lost + now.lost_open - now.lost()) / now.lost(), 1e-9,
              "each loss is in one of them");
}

TEST(Flow, keeps_number_mass_and_energy_of_balls_that_circulate) {
  books_close("recirculated", hopper(0.016), Feed::recirculate, 100);
}
TEST(Flow, keeps_number_mass_and_energy_of_a_batch) {
  books_close("batch", hopper(0.016), Feed::none, 100);
}
TEST(Flow, keeps_number_mass_and_energy_of_a_metered_feed) {
  books_close("metered", hopper(0.016), Feed::rate, 50);
}
TEST(Flow, keeps_number_mass_and_energy_in_a_jar_that_is_shaken) {
  books_close("shaken", hopper(0.016, shaken(30, 0.002)), Feed::recirculate, 100);
}

TEST(Flow, a_metered_feed_enters_at_its_rate) {
  const auto run = engine(hopper(0.016), grains(400, 0.001), flow(Feed::rate));
  FlowObserver seen;
  run->advance(0.2, seen);
  const double first = seen.all.empty() ? 0 : seen.all.front().time;
  const double at_most = 300 * (0.2 - first) + 1;
  states("balls that entered", seen.count(true), at_most - 0.5, 1.5, "rate times time");
}

TEST(Flow, a_ball_outside_touches_nothing_and_stays) {
  const auto run = engine(hopper(0.016), grains(400, 0.001), flow(Feed::none));
  FlowObserver seen;
  run->advance(0.1, seen);
  const auto before = run->balls();
  const std::size_t hits = seen.hits.size();
  run->advance(0.2, seen);
  const auto after = run->balls();
  const auto forces = run->forces();
  ASSERT_EQ(forces.size(), after.size());
  int outside = 0;
  for (std::size_t i = 0; i < before.size(); ++i) {
    if (!before[i].outside) continue;
    ++outside;
    EXPECT_TRUE(after[i].outside);
    EXPECT_EQ(after[i].position, before[i].position);
    EXPECT_EQ(after[i].velocity, Vec3{});
    EXPECT_EQ(forces[i], Vec3{});
    EXPECT_EQ(after[i].radius, before[i].radius);
  }
  EXPECT_GT(outside, 20);
  for (std::size_t k = hits; k < seen.hits.size(); ++k)
    if (seen.hits[k].time > 0.1) {
      EXPECT_FALSE(before[static_cast<std::size_t>(seen.hits[k].ball)].outside);
      if (seen.hits[k].other >= 0) {
        EXPECT_FALSE(before[static_cast<std::size_t>(seen.hits[k].other)].outside);
      }
    }
}

/// The upper half of a bed is left when the lower half, pressed by its weight, leaves at once.
TEST(Flow, takes_along_what_pressed_contacts_store) {
  scene::Chamber jar = hopper(0.016);
  jar.parts.clear();
  const auto settling = engine(jar, grains(400, 0.001), std::nullopt);
  FlowObserver ignored;
  settling->advance(0.3, ignored);
  const auto bed = settling->balls();
  double middle = 0;
  for (const scene::Ball& b : bed) middle += b.position.z / 400;
  scene::Flow half = flow(Feed::none);
  half.outlet = {0, 0, middle};
  const auto run = engine(jar, bed, half);
  FlowObserver seen;
  run->advance(63e-5, seen);
  const scene::EnergyBalance before = run->energy_balance();
  EXPECT_TRUE(seen.all.empty());
  run->advance(64e-5, seen);
  const scene::EnergyBalance after = run->energy_balance();
  EXPECT_GT(seen.count(false), 100);
  const double stored = before.elastic - after.elastic;
  EXPECT_GT(stored, 0);
  // A step of the bed itself, and tangential springs, which count as dissipated on both sides.
  stays_below("energy that is missing over what the contacts stored",
              std::abs(after.residual() - before.residual()) / stored, 0.01, "flo.3");
}

TEST(Flow, in_which_nothing_leaves_changes_no_bit) {
  scene::Flow far = flow(Feed::recirculate);
  far.outlet = {0, 0, -1};
  const scene::Chamber jar = hopper(0.016, shaken(30, 0.002));
  const auto balls = grains(400, 0.001);
  const auto with = engine(jar, balls, far), without = engine(jar, balls, std::nullopt);
  FlowObserver seen, other;
  with->advance(0.05, seen), without->advance(0.05, other);
  EXPECT_TRUE(seen.all.empty());
  expect_same(*with, *without);
  EXPECT_EQ(seen.hits.size(), other.hits.size());
}

TEST(Flow, may_empty_a_jar) {
  scene::Flow all = flow(Feed::none);
  all.outlet = {0, 0, -0.010};
  scene::Chamber jar = hopper(0.016);
  jar.parts.clear();
  const auto run = engine(jar, grains(200, 0.001), all);
  FlowObserver seen;
  run->advance(0.3, seen);
  states("balls that left", seen.count(false), 200, 0, "the outlet is above the floor");
  const scene::EnergyBalance now = run->energy_balance();
  states("energy inside [J]", now.kinetic + now.potential + now.elastic, 0, 0, "nothing is inside");
  stays_below("residual over what left", std::abs(now.residual() / now.flow), 1e-3, "flo.3");
}

TEST(Flow, has_the_same_bits_on_two_threads) {
  scene::Chamber jar = hopper(0.016, shaken(30, 0.002));
  jar.parts.clear();
  scene::Flow below = flow(Feed::recirculate);
  below.outlet = {0, 0, -0.011};  // the lowest balls leave at once, others later
  const auto balls = grains(2000, 0.0009);
  const auto one = engine(jar, balls, below), two = engine(jar, balls, below, 2);
  FlowObserver of_one, of_two;
  one->advance(0.008, of_one), two->advance(0.008, of_two);
  EXPECT_GT(of_one.count(false), 20);
  EXPECT_GT(of_one.count(true), 20);
  expect_same(*one, *two);
  ASSERT_EQ(of_one.all.size(), of_two.all.size());
  for (std::size_t i = 0; i < of_one.all.size(); ++i)
    ASSERT_TRUE(same_bits(of_one.all[i], of_two.all[i])) << i;
}

TEST(Flow, has_the_same_bits_however_a_run_is_cut_and_resumed) {
  for (const Feed feed : {Feed::recirculate, Feed::rate, Feed::none}) {
    const scene::Chamber jar = hopper(0.016, shaken(30, 0.002));
    auto balls = grains(400, 0.001);
    for (std::size_t i = 350; i < 400; ++i) balls[i].outside = true;
    const auto whole = engine(jar, balls, flow(feed));
    auto cut = engine(jar, balls, flow(feed));
    FlowObserver of_whole, of_cut;
    whole->advance(0.1, of_whole);
    double time = 0;
    for (const double step : {0.01, 0.0003, 0.0351, 0.00064, 0.0299, 0.01}) {
      time += step;
      cut->advance(time, of_cut);
      Archive saved;
      cut->serialize(saved);
      cut = engine(jar, balls, flow(feed));
      Archive read(saved.bytes());
      cut->serialize(read);
      read.finish();
    }
    cut->advance(0.1, of_cut);
    EXPECT_GT(of_whole.count(false), 20);
    expect_same(*whole, *cut);
    ASSERT_EQ(of_whole.all.size(), of_cut.all.size());
    for (std::size_t i = 0; i < of_whole.all.size(); ++i)
      ASSERT_TRUE(same_bits(of_whole.all[i], of_cut.all[i])) << i;
    ASSERT_EQ(of_whole.hits.size(), of_cut.hits.size());
  }
}

}  // namespace
}  // namespace mahlwerk::tests::flow_test
