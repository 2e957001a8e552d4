// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Balls that leave the jar and enter it again: nothing is lost in number, mass and energy (flo.2,
// flo.3), and the bits do not depend on threads and cuts.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include "crowd.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/soft/walls/chamber_wall.hpp"
#include "same_bits.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::flow_test {
namespace {

using Feed = scene::Flow::Feed;

/// Records collisions and passages.
class FlowObserver final : public scene::Observer {
 public:
  void collisions(std::span<const scene::Collision> finished) override {
    hits.insert(hits.end(), finished.begin(), finished.end());
  }
  void passages(std::span<const scene::Passage> passed) override {
    all.insert(all.end(), passed.begin(), passed.end());
  }
  double count(bool entered) const {
    return static_cast<double>(std::ranges::count(all, entered ? 1 : 0, &scene::Passage::entered));
  }
  double mass(bool entered) const {
    double sum = 0;
    for (const scene::Passage& p : all)
      if (p.entered == (entered ? 1 : 0)) sum += p.mass;
    return sum;
  }
  std::vector<scene::Collision> hits;
  std::vector<scene::Passage> all;
};

/// A cylinder of 40 mm by 60 mm with a ring as its floor, 10 mm above the lower end.
scene::Chamber hopper(double hole, const kinematics::AnyMotion& motion = kinematics::Still{}) {
  scene::Chamber jar{geometry::Cylinder{0.04, 0.06}, motion, {}, {0, 0, -gravity}};
  scene::MachinePart floor;
  floor.solid = geometry::AnySolid(geometry::RingSolid{0.044, hole, 0.004});
  floor.position = {0, 0, -0.018};
  jar.parts.push_back(floor);
  return jar;
}

/// What leaves through the hole enters below the lid.
scene::Flow flow(Feed feed) {
  return {.outlet = {0, 0, -0.022},
          .outlet_normal = {0, 0, -1},
          .feed = feed,
          .axes = {},
          .inlet = {0, 0, 0.022},
          .inlet_size = {0.02, 0.02, 0.01},
          .rate = 300,
          .seed = 1};
}

std::vector<scene::Ball> grains(int count, double radius) {
  std::vector<scene::Ball> balls;
  for (const scene::Ball& b : lattice_of(40000, 2.1 * radius, {radius, 0.8 * radius}, 0.1))
    if (static_cast<int>(balls.size()) < count && std::hypot(b.position.x, b.position.y) < 0.018 &&
        b.position.z > -0.014 && b.position.z < 0.028)
      balls.push_back(b);
  for (std::size_t i = 0; i < balls.size(); ++i) balls[i].kind = 0;
  EXPECT_EQ(static_cast<int>(balls.size()), count);
  return balls;
}

std::unique_ptr<scene::Engine> engine(const scene::Chamber& jar,
                                      const std::vector<scene::Ball>& balls,
                                      const std::optional<scene::Flow>& flow, int threads = 1) {
  soft::Settings rules{of_law(contact::HertzMindlin{}, contact::Rolling::cdt), 1e-5, true};
  rules.few_ball_limit = 0;
  rules.threads = threads;
  rules.max_initial_overlap = 0.5;
  rules.flow = flow;
  contact::Pair pair = pair_of({2e6, 0.3}, {2e6, 0.3}, 0.6, 0.4);
  pair.rolling_friction = 0.02;
  return soft::make_engine(jar, balls, rules,
                           contact::PairTable(1, soft::moving_wall(jar)->faces(), pair), 0);
}

double mass_of(const std::vector<scene::Ball>& balls, bool outside) {
  double sum = 0;
  for (const scene::Ball& b : balls) sum += b.outside == outside ? b.mass() : 0;
  return sum;
}

/// The worst residual of the energy over the dissipated, without flow: the error of the time step.
double error_without_flow(const scene::Chamber& jar) {
  const auto run = engine(jar, grains(400, 0.001), std::nullopt);
  const double first = run->energy_balance().residual();
  FlowObserver seen;
  double worst = 0;
  for (int k = 1; k <= 20; ++k) {
    run->advance(0.01 * k, seen);
    worst = max_or_nan(worst, std::abs(run->energy_balance().residual() - first));
  }
  return worst / run->energy_balance().lost();
}

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

/// The grains of another hopper, all outside, in two kinds of half the number each.
std::vector<scene::Ball> fresh_feed(int count) {
  std::vector<scene::Ball> balls = grains(count, 0.001);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    balls[i].outside = true;
    balls[i].position = {};
    if (2 * i >= balls.size()) balls[i].radius *= 0.8;
  }
  return balls;
}

scene::Flow fresh_flow(double rate) {
  scene::Flow fresh = flow(Feed::rate);
  fresh.rate = rate;
  fresh.returns = false;
  return fresh;
}

TEST(FreshFeed, fills_an_empty_jar_and_keeps_number_mass_and_energy) {
  const scene::Chamber jar = hopper(0.016);
  const std::vector<scene::Ball> start = fresh_feed(400);
  const auto run = engine(jar, start, fresh_flow(1500));
  FlowObserver seen;
  double number = 0, mass = 0, energy = 0;
  for (int k = 1; k <= 100; ++k) {
    run->advance(0.003 * k, seen);
    const auto balls = run->balls();
    const auto inside =
        static_cast<double>(std::ranges::count(balls, false, &scene::Ball::outside));
    number = std::max(number, std::abs(inside - seen.count(true) + seen.count(false)));
    mass = max_or_nan(mass, std::abs(mass_of(balls, false) - seen.mass(true) + seen.mass(false)));
    energy = max_or_nan(energy, std::abs(run->energy_balance().residual()));
  }
  std::vector<std::int32_t> entered;
  for (const scene::Passage& p : seen.all)
    if (p.entered != 0) entered.push_back(p.ball);
  std::ranges::sort(entered);
  states("balls that entered", seen.count(true), 400, 0, "the whole feed, once");
  EXPECT_EQ(std::ranges::adjacent_find(entered), entered.end()) << "none entered twice";
  EXPECT_GT(seen.count(false), 50);
  states("balls that are missing", number, 0, 0, "inside + left - entered = 0 (flo.2)");
  stays_below("mass that is missing, relative", mass / mass_of(start, true), 1e-12,
              "rounding of the sums (flo.2)");
  stays_below("energy that is missing over the dissipated", energy / run->energy_balance().lost(),
              3 * error_without_flow(jar), "three times that without flow (flo.3)");
}

/// Balls that start from rest at one height and not at one time never meet in free fall: the jar
/// fills until as many leave as enter, each after the time of its fall.
TEST(FreshFeed, falls_through_an_empty_jar_in_the_time_of_free_fall) {
  scene::Chamber jar = hopper(0.016);
  jar.parts.clear();
  scene::Flow rain = fresh_flow(500);
  rain.inlet_size = {0.02, 0.02, 0};
  const auto run = engine(jar, fresh_feed(150), rain);
  FlowObserver seen;
  run->advance(0.25, seen);
  EXPECT_TRUE(seen.hits.empty());
  const double fall = std::sqrt(2 * (rain.inlet.z - rain.outlet.z) / gravity),
               between_moves = 64 * 1e-5;
  std::vector<double> entered(150, -1);
  double worst = 0, left = 0;
  for (const scene::Passage& p : seen.all) {
    double& since = entered[static_cast<std::size_t>(p.ball)];
    if (p.entered == 0) ++left, worst = max_or_nan(worst, std::abs(p.time - since - fall));
    since = p.time;
  }
  EXPECT_GT(left, 50);
  states("worst residence time less that of the fall [s]", worst, 0, between_moves,
         "balls are moved every 64th step");
  const auto balls = run->balls();
  const auto inside = static_cast<double>(std::ranges::count(balls, false, &scene::Ball::outside));
  states("steady holdup", inside, rain.rate * fall, 1 + rain.rate * between_moves,
         "rate times the time of the fall (flo.5)");
}

/// The first half of the feed has as many balls of each size as the second, but for chance.
TEST(FreshFeed, is_mixed) {
  const auto run = engine(hopper(0.016), fresh_feed(400), fresh_flow(1000));
  FlowObserver seen;
  run->advance(0.2, seen);
  double large = 0, all = 0;
  for (const scene::Passage& p : seen.all)
    if (p.entered != 0) ++all, large += p.ball < 200 ? 1 : 0;
  EXPECT_GT(all, 150);
  states("share of the large half", large / all, 0.5, 4 * 0.5 / std::sqrt(2 * all),
         "four standard deviations of drawing half of them without return");
}

TEST(FreshFeed, by_mass_enters_at_its_mass_rate) {
  scene::Flow by_mass = fresh_flow(1);
  by_mass.mass_rate = 0.008;
  const std::vector<scene::Ball> balls = fresh_feed(400);
  const auto run = engine(hopper(0.016), balls, by_mass);
  FlowObserver seen;
  run->advance(0.2, seen);
  states("mass that entered [kg]", seen.mass(true), by_mass.mass_rate * 0.2,
         balls.front().mass() + by_mass.mass_rate * 64e-5, "rate times time, within a ball");
}

TEST(FreshFeed, that_recirculates_enters_again) {
  scene::Flow circuit = fresh_flow(3000);
  circuit.returns = true;
  const auto run = engine(hopper(0.016), fresh_feed(200), circuit);
  FlowObserver seen;
  run->advance(0.3, seen);
  EXPECT_GT(seen.count(true), 220);
}

}  // namespace
}  // namespace mahlwerk::tests::flow_test
