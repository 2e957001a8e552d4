// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Grains that break while they move (docs/theory/bed-breakage.md).
#include <gtest/gtest.h>

#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/random.hpp"
#include "same_bits.hpp"
#include "statement.hpp"
#include "verification/soft/breaking.hpp"

namespace mahlwerk::tests::bed_breakage_test {
namespace {

using namespace breaking;

constexpr double step = 2e-7;

/// Share of grains that break in one impact on a wall of their material at `speed` [m/s].
double broken_share(const powder::AnyBreakage& breakage, double speed, int side, double e = 0.6) {
  const powder::BedBreakage rule = bed(breakage);
  const auto spare = static_cast<std::size_t>(2 * side * side);
  const auto run =
      engine(box_for(side), with_spare(falling(side, speed), rule, spare), rule, step, e);
  SizeObserver seen;
  run->advance(1e-3 / speed + 5e-5, seen);
  return static_cast<double>(seen.broken_of(0)) / (side * side);
}

TEST(BedBreakage, a_grain_receives_half_of_its_impact_energy_at_a_wall_of_its_material) {
  constexpr double speed = 10, energy = 0.25 * speed * speed;  // half of 1/2 v^2 (bed.2)
  for (const double e : {0.3, 0.6, 1.0}) {
    const auto breaks_at = [&](double threshold) {
      return broken_share(powder::Threshold{threshold, 1e-3, 0}, speed, 2, e);
    };
    states("share broken, threshold 1.5 % below the energy", breaks_at(0.985 * energy), 1, 0,
           "(bed.1), (bed.2)");
    states("share broken, threshold 1.5 % above the energy", breaks_at(1.015 * energy), 0, 0,
           "(bed.1), (bed.2)");
  }
}

TEST(BedBreakage, the_share_broken_by_one_impact_is_the_probability) {
  constexpr int side = 30;
  for (const double speed : {8.0, 12.0}) {
    const powder::VogelPeukert model{20, 4e-3};
    const double p = model.breakage_probability(2 * radius, 0.25 * speed * speed);
    states("share broken, Vogel and Peukert", broken_share(model, speed, side), p,
           4 * std::sqrt(p * (1 - p)) / side, "four standard deviations of 900 grains");
    const powder::Tavares tavares = {20, 1e-3, 1, 0.5, 4, 5, 0.6, 0.03};
    const double q = tavares.breakage_probability(2 * radius, 0.25 * speed * speed);
    states("share broken, Tavares", broken_share(tavares, speed, side), q,
           4 * std::sqrt(q * (1 - q)) / side, "four standard deviations of 900 grains");
  }
}

/// A grain on the floor, and a heavy ball of the same material that falls on it.
std::int64_t broken_by_ball(double threshold) {
  const powder::BedBreakage rule = [&] {
    powder::BedBreakage made = bed(powder::Threshold{threshold, 1e-3, 0});
    made.kind = 1;
    return made;
  }();
  constexpr double heavy = 8 * radius, speed = 0.5;
  std::vector<scene::Ball> balls{
      sphere(heavy, {0, 0, -0.1 + 2.001 * radius + heavy}, {0, 0, -speed}),
      sphere(radius, {0, 0, -0.1 + 0.9999 * radius}, {}, {}, 1)};
  soft::Settings settings{of_law(contact::HertzMindlin{}), step, true};
  settings.breakage = powder::grain_breakage(rule);
  const contact::Pair pair = pair_of(material, material, 1.0);
  const auto run = soft::make_engine(still_box(0.2), with_spare(balls, rule, 200), settings,
                                     contact::PairTable(2, 6, pair), 0);
  SizeObserver seen;
  run->advance(8e-4, seen);
  return seen.broken_of(0);
}

TEST(BedBreakage, a_grain_between_ball_and_wall_receives_the_energy_of_both_contacts) {
  // The ball's energy is stored in two contacts of the grain, which takes half of each (bed.3).
  const double energy = 0.5 * 0.5 * 512 * 0.5 * 0.5;  // [J/kg] of the grain
  states("broken, threshold 5 % below", static_cast<double>(broken_by_ball(0.95 * energy)), 1, 0,
         "(bed.3), inertia of the grain 1/512");
  states("broken, threshold 5 % above", static_cast<double>(broken_by_ball(1.05 * energy)), 0, 0,
         "(bed.3), inertia of the grain 1/512");
}

/// A shaken box of grains that break.
struct Shaken {
  std::vector<scene::Ball> start;
  powder::BedBreakage rule;
  scene::Chamber jar;
};
Shaken shaken(const powder::AnyBreakage& breakage, const powder::AnyFragments& fragments,
              std::size_t spare = 4000) {
  Shaken made;
  made.rule = bed(breakage, fragments);
  made.jar = {
      geometry::Cylinder{0.02, 0.02}, kinematics::Vibration{{}, 50, 0.008}, {}, {0, 0, -gravity}};
  Random random(3, 0);
  for (int i = 0; i < 288; ++i) {
    const Vec3 cell{i % 6 - 2.5, static_cast<double>(i / 6 % 6) - 2.5, static_cast<double>(i / 36)};
    if (std::hypot(cell.x, cell.y) * 2.2 * radius > 0.01 - 1.05 * radius) continue;
    made.start.push_back(sphere(radius, 2.2 * radius * cell + Vec3{0, 0, -0.0085},
                                random.uniform(0, 1) * random.direction()));
  }
  made.start = with_spare(made.start, made.rule, spare);
  return made;
}

double powder_mass(const std::vector<scene::Ball>& balls) {
  double sum = 0;
  for (const scene::Ball& b : balls) sum += b.outside ? 0 : b.mass();
  return sum;
}

TEST(BedBreakage, mass_and_energy_are_kept_as_grains_break) {
  const Shaken made =
      shaken(powder::Threshold{0.2, 1e-3, 0.5}, powder::AustinFragments{0.4, 0.8, 3});
  const auto run = engine(made.jar, made.start, made.rule, 1e-6);
  const double mass = powder_mass(made.start);
  const int spheres = static_cast<int>(made.rule.diameters().size());
  SizeObserver seen;
  double missing = 0, energy = 0;
  for (int k = 1; k <= 40; ++k) {
    run->advance(0.002 * k, seen);
    double fines = 0;
    for (std::size_t c = static_cast<std::size_t>(spheres); c < seen.gained.size(); ++c)
      fines += seen.gained[c];
    missing = max_or_nan(missing, std::abs(powder_mass(run->balls()) + fines - mass));
    energy = max_or_nan(energy, std::abs(run->energy_balance().residual()));
  }
  const scene::EnergyBalance now = run->energy_balance();
  std::printf("    %.0f grains broke, %zu bodies\n", static_cast<double>(now.broken_grains),
              run->balls().size());
  EXPECT_GT(now.broken_grains, 100);
  EXPECT_EQ(now.broken_grains, seen.broken);
  stays_below("mass that is missing, relative", missing / mass, 1e-12, "rounding of the sums");
  stays_below("sum of the changes of all classes, relative",
              std::abs(std::accumulate(seen.gained.begin(), seen.gained.end(), 0.0)) / mass, 1e-12,
              "rounding of the sums");
  stays_below("energy that is missing over that of the breakage", energy / now.lost_breakage, 0.03,
              "half a step of the contacts of grains that leave pressed (bed.9)");
}

/// A cloud of grains without gravity: nothing but their collisions acts.
TEST(BedBreakage, fragments_take_the_momentum_of_their_grain_and_gain_no_energy) {
  const powder::BedBreakage rule =
      bed(powder::Threshold{30, 1e-3, 0}, powder::AustinFragments{0.4, 0.8, 3});
  std::vector<scene::Ball> pair{sphere(radius, {-1.02 * radius, 0, 0}, {8, 0.5, 0}, {50, 20, 90}),
                                sphere(radius, {1.02 * radius, 0, 0}, {-8, 0, 0.3})};
  const auto start = with_spare(pair, rule, 200);
  const auto run = engine(still_box(0.1), start, rule, step);
  SizeObserver seen;
  const auto momentum = [&] {
    Vec3 sum;
    for (const scene::Ball& b : run->balls())
      if (!b.outside) sum += b.mass() * b.velocity;
    return sum;
  };
  double before = run->energy_balance().kinetic, most = 0, turned = 0;
  Vec3 last = momentum();
  double mass = powder_mass(run->balls());
  bool broke = false;
  for (int k = 1; k <= 400; ++k) {
    const std::int64_t count = run->energy_balance().broken_grains;
    run->advance(k * step, seen);
    const double now_mass = powder_mass(run->balls());
    if (run->energy_balance().broken_grains == count)
      turned = std::max(turned, norm(momentum() - last) / (mass * 8));
    broke = broke || now_mass < mass;
    mass = now_mass, last = momentum();
    most = std::max(most, run->energy_balance().kinetic + run->energy_balance().elastic - before);
  }
  EXPECT_EQ(run->energy_balance().broken_grains, 2);
  stays_below("momentum that appears in steps without breakage, relative", turned, 1e-9,
              "action and reaction, in records of double precision");
  stays_below("kinetic and elastic energy that appears over the initial", most / before, 1e-3,
              "(bed.6): the error of the time step");
  stays_below("energy that is missing over the initial",
              std::abs(run->energy_balance().residual()) / before, 0.014,
              "half a step of a contact of 115 steps: pi/2/115 (bed.9)");
}

TEST(BedBreakage, mass_shares_of_fragments_are_exact_over_many_grains) {
  const powder::BedBreakage rule =
      bed(powder::Threshold{24, 1e-3, 0}, powder::AustinFragments{0.4, 0.8, 3});
  constexpr int side = 20;
  const auto run = engine(box_for(side), with_spare(falling(side, 10), rule, 60000), rule, step);
  SizeObserver seen;
  run->advance(3e-5, seen);
  const double broken = static_cast<double>(seen.broken);
  EXPECT_EQ(seen.broken, side * side);
  const auto model = powder::grain_breakage(rule);
  scene::GrainState grain;
  grain.size = 2 * radius;
  const std::vector<double> shares = model->fragment_shares(grain);
  const scene::Ball whole = sphere(radius);
  double worst = 0;
  const std::vector<double> diameters = rule.diameters();
  for (std::size_t k = 1; k < diameters.size(); ++k) {
    const double each = std::pow(diameters[k] / diameters[0], 3);
    worst = std::max(worst, std::abs(seen.gained[k] / whole.mass() - broken * shares[k]) / each);
  }
  stays_below("spheres too many or too few of a class", worst, 1 + 1e-6, "(bed.5)");
}

TEST(BedBreakage, damage_of_many_impacts_is_that_of_the_model) {
  // Grains between two walls: every crossing is an impact of nearly the same energy.
  const powder::Tavares model = {30, 1e-3, 1, 0.5, 4, 5, 0.6, 0.03};
  constexpr int side = 30;
  constexpr double speed = 8;
  constexpr int samples = 3;
  std::vector<double> broken(3);
  for (int sample = 1; sample <= samples; ++sample) {
    powder::BedBreakage rule = bed(model);
    rule.seed = static_cast<std::uint64_t>(sample);
    const auto run =
        engine(box_for(side), with_spare(falling(side, speed), rule, 3000), rule, step, 1);
    SizeObserver seen;
    for (int hit = 1; hit <= 3; ++hit) {
      run->advance((hit - 0.5) * 0.198 / speed, seen);
      broken[static_cast<std::size_t>(hit - 1)] += static_cast<double>(seen.broken_of(0));
    }
  }
  const double grains = samples * side * side;
  // The model alone, for the same number of impacts, by many grains.
  Random random(11, 0);
  constexpr int many = 20000;
  std::vector<double> expected(3);
  for (int i = 0; i < many; ++i) {
    const double radius_of_pair = std::sqrt(-2 * std::log(random.uniform()));
    const double z = radius_of_pair * std::cos(2 * M_PI * random.uniform());
    double strength = model.median(2 * radius) * model.relative_strength(z);
    for (int hit = 0; hit < 3; ++hit) {
      const double load = 0.25 * speed * speed / strength;
      if (load >= 1) {
        for (int later = hit; later < 3; ++later)
          expected[static_cast<std::size_t>(later)] += 1.0 / many;
        break;
      }
      strength *= 1 - model.damage(load);
    }
  }
  for (std::size_t hit = 0; hit < 3; ++hit) {
    const double p = expected[hit];
    states("share broken after impacts", broken[hit] / grains, p,
           4 * std::sqrt(p * (1 - p) / grains),
           "brk.6 alone, four standard deviations of 2700 grains");
  }
}

TEST(BedBreakage, coarse_grains_keep_their_spheres_and_their_mass) {
  Shaken made = shaken(powder::Threshold{0.2, 1e-3, 0.5}, powder::AustinFragments{0.4, 0.8, 3}, 1);
  made.rule.coarse = true;
  made.rule.feed = {.law = powder::Feed::Law::equal, .size = 0.2e-3};
  made.start.resize(made.start.size() - 7);
  const auto run = engine(made.jar, made.start, made.rule, 1e-6);
  const auto without = powder_mass(run->balls());
  SizeObserver seen;
  run->advance(0.05, seen);
  EXPECT_GT(seen.broken, 100);
  EXPECT_EQ(powder_mass(run->balls()), without);
  stays_below("sum of the changes of all classes, relative",
              std::abs(std::accumulate(seen.gained.begin(), seen.gained.end(), 0.0)) / without,
              1e-12, "rounding of the sums");
}

TEST(BedBreakage, a_full_reserve_makes_coarse_grains) {
  Shaken made = shaken(powder::Threshold{0.2, 1e-3, 0.5}, powder::AustinFragments{0.4, 0.8, 3}, 7);
  const auto run = engine(made.jar, made.start, made.rule, 1e-6);
  SizeObserver seen;
  run->advance(0.05, seen);
  EXPECT_GT(seen.broken, 50);
  EXPECT_EQ(run->balls().size(), made.start.size());
}

TEST(BedBreakage, bits_do_not_depend_on_threads_and_cuts) {
  const Shaken made = shaken(powder::VogelPeukert{5, 1e-5}, powder::AustinFragments{0.4, 0.8, 3});
  SizeObserver one_seen, two_seen, cut_seen;
  const auto one = engine(made.jar, made.start, made.rule, 1e-6);
  one->advance(0.01, one_seen);
  EXPECT_GT(one_seen.broken, 3);
  const auto two = engine(made.jar, made.start, made.rule, 1e-6, 0.6, 2);
  two->advance(0.01, two_seen);
  expect_same(*one, *two);
  auto cut = engine(made.jar, made.start, made.rule, 1e-6);
  for (const double time : {0.00301, 0.004777, 0.0083, 0.01}) {
    cut->advance(time, cut_seen);
    Archive saved;
    cut->serialize(saved);
    cut = engine(made.jar, made.start, made.rule, 1e-6);
    Archive read(saved.bytes());
    cut->serialize(read);
  }
  expect_same(*one, *cut);
  EXPECT_EQ(one_seen.all.size(), cut_seen.all.size());
}

}  // namespace
}  // namespace mahlwerk::tests::bed_breakage_test
