// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The soft engine for many balls (ManyBodySolver): the same physics as for few balls, and the same
// bits however a run is cut, stopped, divided among threads or compiled.
#include "crowd.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <functional>
#include <string>

#include "isas.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "same_bits.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::crowd_test {
namespace {

using contact::HertzMindlin;
using contact::Rolling;

TEST(ManyBodySolver, states_overlaps_in_the_radius_of_the_smaller_ball_as_with_few_balls) {
  const contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, 1);
  const scene::Ball large{0.01, 7850, {-0.011, 0, 0}, {1, 0, 0}, {}},
      small{0.008, 7850, {0.008, 0, 0}, {}, {}};  // of one size class: one chunk has both
  const scene::Chamber box = still_box(0.1);
  const double expected = contact::hertz_overlap(touching(pair, {large, small}), 1) / small.radius;
  for (const bool large_first : {true, false})
    for (const std::size_t few : {std::size_t{0}, std::size_t{32}}) {
      // The solver for many balls orders them by position, that for few by their number.
      std::vector<scene::Ball> balls{large, small};
      if (!large_first) {
        std::swap(balls[0], balls[1]);
        for (scene::Ball& b : balls) b.position = -b.position, b.velocity = -b.velocity;
      }
      const auto engine =
          soft::make_engine(box, balls, {of_law(HertzMindlin{}), 1e-7, false, few},
                            contact::PairTable(1, geometry::faces(*box.shape), pair), 0);
      Recorder recorder;
      engine->advance(0.002, recorder);
      // The errors of the integrator and of the sampling are of the order (pi dt/t_H)^2 = 1e-6; ten
      // times that.
      states(fmt::format("{} balls, {} first", few == 0 ? "many" : "few",
                         large_first ? "large" : "small"),
             engine->energy_balance().deepest_overlap, expected, 1e-5 * expected,
             "Hertz, elastic (dem.8)");
    }
}

TEST(ManyBodySolver, moves_as_few_balls_do) {
  // Same laws and same steps, but sums in another order: rounding errors grow with each collision.
  // The tolerance of positions follows from a third run whose start is displaced by 1e-13 m.
  for (const World& w : worlds()) {
    SCOPED_TRACE(w.name);
    World aside = w;
    for (scene::Ball& b : aside.balls) b.position.x += 1e-13;
    const auto few = crowd(w, 1, 1000), many = crowd(w), nudged = crowd(aside);
    Recorder by_few, by_many, by_nudged;
    const double time = 0.012;
    few->advance(time, by_few);
    many->advance(time, by_many);
    nudged->advance(time, by_nudged);
    const auto a = few->balls(), b = many->balls(), c = nudged->balls();
    double off = 0, grown = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      off = max_or_nan(off, norm(a[i].position - b[i].position));
      grown = max_or_nan(grown, norm(c[i].position - b[i].position));
    }
    EXPECT_GT(by_many.all.size(), 30U);
    EXPECT_EQ(by_few.all.size(), by_many.all.size());
    stays_below(w.name + ": positions off after 12 ms [m]", off, std::max(1e-12, 10 * grown),
                "the same by all pairs; grown from 1e-13 m");
    const scene::EnergyBalance x = few->energy_balance(), y = many->energy_balance();
    const double scale = x.kinetic + std::abs(x.wall_work) + x.lost();
    for (const auto part : {&scene::EnergyBalance::kinetic, &scene::EnergyBalance::elastic,
                            &scene::EnergyBalance::wall_work, &scene::EnergyBalance::lost_normal,
                            &scene::EnergyBalance::lost_tangential,
                            &scene::EnergyBalance::lost_rolling, &scene::EnergyBalance::slid})
      EXPECT_NEAR(x.*part, y.*part, std::max(1e-9, 1e6 * grown) * scale);
    EXPECT_NEAR(x.contact_time, y.contact_time, 20 * w.step);
    EXPECT_EQ(x.lasting_contacts, y.lasting_contacts);
  }
}

TEST(ManyBodySolver, is_the_same_to_the_bit_however_it_is_cut_stopped_and_shared) {
  constexpr double time = 0.02;
  for (const World& w : worlds()) {
    SCOPED_TRACE(w.name);
    const auto whole = crowd(w), pieces = crowd(w, 2), before = crowd(w, 2), after = crowd(w);
    Recorder in_one, in_many, in_two;
    whole->advance(time, in_one);
    EXPECT_GT(in_one.all.size(), 50U);
    Random random(3, 0);
    std::vector<double> cuts{time};
    for (int i = 0; i < 200; ++i) cuts.push_back(random.uniform(0, time));
    std::ranges::sort(cuts);
    for (const double cut : cuts) pieces->advance(cut, in_many);
    expect_same(in_one, in_many);
    expect_same(*whole, *pieces);
    before->advance(0.01137, in_two);
    copy_state(*before, *after);
    after->advance(time, in_two);
    expect_same(in_one, in_two);
    expect_same(*whole, *after);
  }
}

TEST(ManyBodySolver, of_several_chunks_has_the_same_bits_by_threads_and_registers) {
  const World w = drum_of(4000);
  const auto one = crowd(w), three = crowd(w, 3);
  Recorder by_one, by_three;
  one->advance(0.006, by_one);
  three->advance(0.006, by_three);
  EXPECT_GT(by_one.all.size(), 1000U);
  expect_same(by_one, by_three);
  expect_same(*one, *three);
  for (const Isa isa : supported_isas()) {
    SCOPED_TRACE(name_of(isa));
    const ChosenIsa chosen(isa);
    const auto narrow = crowd(w, 2);
    Recorder by_narrow;
    narrow->advance(0.006, by_narrow);
    expect_same(by_one, by_narrow);
    expect_same(*one, *narrow);
  }
}

TEST(SoftEngine, has_the_same_bits_on_every_instruction_set) {
  std::vector<World> all = worlds();
  World five = all.front();
  five.name = "five balls", five.balls = lattice_of(5, 0.0055, {0.0025});
  all.push_back(five);
  for (const World& w : all)
    for (const std::size_t few : {std::size_t{0}, std::size_t{1000}}) {
      SCOPED_TRACE(w.name + (few == 0 ? ", solver for many" : ", solver for few"));
      const auto widest = crowd(w, 1, few);
      Recorder by_widest;
      widest->advance(0.02, by_widest);
      EXPECT_GT(by_widest.all.size(), 0U);
      for (const Isa isa : supported_isas()) {
        SCOPED_TRACE(name_of(isa));
        const ChosenIsa chosen(isa);
        const auto other = crowd(w, 1, few);
        Recorder by_other;
        other->advance(0.02, by_other);
        expect_same(by_widest, by_other);
        expect_same(*widest, *other);
      }
    }
}

TEST(ManyBodySolver, closes_its_energy_and_keeps_its_momentum) {
  World w = drum_of(3000);
  const auto drum = crowd(w, 2);
  Recorder seen;
  drum->advance(0.03, seen);
  const scene::EnergyBalance a = drum->energy_balance();
  stays_below("drum of 3000: energy balance over work done",
              std::abs(a.residual()) / (std::abs(a.wall_work) + a.lost()), 1e-3, "(dem.32)");
  World gas = worlds().back();
  gas.balls = lattice_of(2197, 0.0023, {0.001}, 0.5);
  const auto engine = crowd(gas, 2);
  const auto momentum = [](const std::vector<scene::Ball>& balls) {
    Vec3 sum{};
    for (const scene::Ball& b : balls) sum += b.mass() * b.velocity;
    return sum;
  };
  const Vec3 before = momentum(engine->balls());
  engine->advance(0.02, seen);
  double size = 0;
  for (const scene::Ball& b : engine->balls()) size += b.mass() * norm(b.velocity);
  stays_below("gas of 2197: momentum gained over all there is",
              norm(momentum(engine->balls()) - before) / size, 1e-12, "Newton's third law");
}

TEST(ManyBodySolver, that_goes_wrong_or_starts_overlapping_says_which_ball) {
  World w = drum_of(3000);
  w.balls[1234].position = w.balls[77].position;
  try {
    crowd(w);
    FAIL() << "overlapping";
  } catch (const InputError& e) {
    EXPECT_EQ(e.faults().front().code, "overlapping-balls");
    EXPECT_NE(e.faults().front().what.find("ball 78"), std::string::npos) << e.what();
  }
  w = drum_of(3000);
  w.balls[1234].velocity = {NAN, 0, 0};
  const auto engine = crowd(w, 2);
  Recorder none;
  try {
    engine->advance(0.01, none);
    FAIL() << "no number";
  } catch (const RunError& e) {
    EXPECT_NE(std::string(e.what()).find("ball 1235"), std::string::npos) << e.what();
    EXPECT_LE(engine->energy_balance().time, 100 * w.step);
  }
}

}  // namespace
}  // namespace mahlwerk::tests::crowd_test
