// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Bitwise reproducibility: a run gives the same bits if it is advanced in several calls, or saved
// and resumed.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "many_balls.hpp"
#include "one_ball.hpp"

namespace mahlwerk::tests::cuts_test {
namespace {

using Make = std::function<std::unique_ptr<scene::Engine>()>;

/// Bytewise comparison. All members of these types are eight bytes wide or come in pairs of four
/// bytes, so there is no padding.
template <class T>
bool same_bits(const T& a, const T& b) {
  return std::memcmp(&a, &b, sizeof(T)) == 0;
}
bool same_bits(const scene::Ball& a, const scene::Ball& b) {
  return a.position == b.position && a.velocity == b.velocity && a.spin == b.spin &&
         a.radius == b.radius && a.density == b.density && a.kind == b.kind;
}

void expect_same(const scene::Engine& a, const scene::Engine& b) {
  scene::EnergyBalance mine = a.energy_balance(), other = b.energy_balance();
  mine.search_steps = other.search_steps = 0;  // effort, not state
  EXPECT_TRUE(same_bits(mine, other));
  const auto balls = a.balls(), others = b.balls();
  ASSERT_EQ(balls.size(), others.size());
  for (std::size_t i = 0; i < balls.size(); ++i) EXPECT_TRUE(same_bits(balls[i], others[i])) << i;
}
void expect_same(const Recorder& a, const Recorder& b) {
  ASSERT_EQ(a.all.size(), b.all.size());
  for (std::size_t i = 0; i < a.all.size(); ++i)
    ASSERT_TRUE(same_bits(a.all[i], b.all[i])) << i << " at " << a.all[i].time;
}

void cut_into_pieces(const Make& make, double time, std::size_t least) {
  const auto whole = make(), pieces = make();
  Recorder in_one, in_many;
  whole->advance(time, in_one);
  ASSERT_GT(in_one.all.size(), least);
  Random random(3, 0);
  std::vector<double> cuts{time};
  for (int i = 0; i < 700; ++i) cuts.push_back(random.uniform(0, time));
  for (std::size_t i = 0; i < 100; ++i) {  // at collisions, and just before and after
    const double at = in_one.all[i * in_one.all.size() / 100].time;
    cuts.insert(cuts.end(), {std::nextafter(at, 0), at, std::nextafter(at, time)});
  }
  std::ranges::sort(cuts);
  for (const double cut : cuts) pieces->advance(cut, in_many);
  expect_same(in_one, in_many);
  expect_same(*whole, *pieces);
}

/// Saves the run at `when`, resumes it in a new engine, and compares it with the uninterrupted run.
void stop_and_go_on(const Make& make, double when, double time) {
  const auto whole = make(), first = make(), second = make();
  Recorder in_one, in_two;
  whole->advance(when, in_one);
  whole->advance(time, in_one);
  first->advance(when, in_two);
  copy_state(*first, *second);
  expect_same(*first, *second);
  second->advance(time, in_two);
  expect_same(in_one, in_two);
  expect_same(*whole, *second);
}

std::vector<scene::Ball> charge(int n, double radius) {
  std::vector<scene::Ball> balls;
  Random random(9, 0);
  for (int i = 0; i < n * n * n; ++i) {
    const Vec3 cell{static_cast<double>(i % n), static_cast<double>(i / n % n),
                    static_cast<double>(i / n / n)};
    balls.push_back({radius * (1 - 0.05 * (i % 3)), 7850,
                     2.1 * radius * (cell - 0.5 * (n - 1) * Vec3{1, 1, 1}),
                     random.uniform(0, 0.3) * random.direction(),
                     random.uniform(0, 30) * random.direction(), i % 2});
  }
  return balls;
}

/// Moduli of steel, for every pair of `kinds` ball sets and the faces of `chamber`.
contact::PairTable steel(int kinds, const scene::Chamber& chamber) {
  return {kinds, geometry::faces(*chamber.shape), {.modulus = 1.1e11, .shear_modulus = 2.3e10}};
}

/// With `joined`, bounces of one contact are joined to one record, and twisting friction acts.
Make many(const scene::Chamber& chamber, int n, double radius, bool joined = false) {
  return [=] {
    event::Rules rules;
    rules.sustained_mode = event::SustainedContactMode::tc;
    const int faces = geometry::faces(*chamber.shape);
    if (joined) rules.elastic = rules.twisting = steel(2, chamber);
    contact::BounceTable table(2, faces, {0.8, 0.3, 0.3});
    table.set_balls(0, 1, {0.6, 0, 0.1});
    return event::many_balls(chamber, charge(n, radius), rules, table, 0.37);
  };
}
const Vec3 down{0, 0, -gravity};
scene::Chamber capsule() {
  return {geometry::Capsule{0.04, 0.03}, shaken(20, 0.015), {}, down};
}
scene::Chamber drum() {
  return {geometry::Cylinder{0.06, 0.04}, kinematics::Tumbling{12}, scene::mounted_along({1, 0, 0}),
          down};
}
scene::Chamber planet() {
  return {geometry::Box{0.04, 0.04, 0.04},
          kinematics::Planetary{.orbit_radius = 0.07, .speed = 30, .ratio = -2},
          {},
          down};
}
/// A ball that is still falling at the first stop and later rolls in the vial; twisting friction
/// acts.
std::unique_ptr<scene::Engine> roller() {
  event::Rules rules = rules_a(0.5);
  rules.bounce.friction = 0.3;
  rules.twisting = steel(1, mill_a());
  return event::one_ball(mill_a(5, 0.002), ball_a({0.0005, 0, 0}, {0.05, 0.02, 0}), rules, 0.1);
}

TEST(Cuts, do_not_change_a_shaken_capsule) {
  cut_into_pieces(many(capsule(), 3, 0.003), 0.3, 500);
}
TEST(Cuts, do_not_change_a_drum) {
  cut_into_pieces(many(drum(), 4, 0.003), 0.2, 500);
}
TEST(Cuts, do_not_change_a_box_on_a_planetary_mill) {
  cut_into_pieces(many(planet(), 4, 0.003), 0.2, 500);
}
TEST(Cuts, do_not_change_joined_bounces) {
  cut_into_pieces(many(drum(), 4, 0.003, true), 0.2, 500);
}
/// A fluid so dense that the engine keeps neighbour lists.
std::unique_ptr<scene::Engine> dense_fluid() {
  return gas(lattice(8, 0.46), side_of(8, 0.46), {1, 1, INFINITY});
}
TEST(Cuts, do_not_change_a_dense_fluid) {
  cut_into_pieces(dense_fluid, 0.5, 3000);
}
TEST(Cuts, do_not_change_one_ball) {
  cut_into_pieces([] { return event::one_ball(mill_a(), ball_a(), rules_a(), 0.1); }, 10, 100);
}
TEST(Cuts, do_not_change_one_ball_that_comes_to_roll) {
  cut_into_pieces(roller, 3, 10);
}

TEST(Archives, of_many_balls_go_on_to_the_bit) {
  for (const double when : {0.0, 1e-3, 0.05, 0.0777})
    for (const scene::Chamber& mill : {capsule(), drum(), planet()})
      for (const bool joined : {false, true})
        stop_and_go_on(many(mill, 3, 0.003, joined), when, 0.15);
}

/// 729 balls. The engine sorts them in memory by cell at every reorganisation, after some 2000
/// collisions.
TEST(Archives, of_balls_sorted_anew_go_on_to_the_bit) {
  const Make make = many({geometry::Capsule{0.08, 0.06}, shaken(20, 0.015), {}, down}, 9, 0.003);
  const auto probe = make();
  Recorder seen;
  probe->advance(0.03, seen);
  ASSERT_GT(seen.all.size(), 5000U) << "renewed some times";
  // Stops at consecutive collisions just before, at and just after the first reorganisation.
  for (std::size_t i = 1955; i < 1965; ++i) stop_and_go_on(make, seen.all[i].time, 0.025);
  for (const double when : {0.01, 0.02}) stop_and_go_on(make, when, 0.03);
}

/// The first reorganisation is after some 1500 collisions.
TEST(Archives, of_a_dense_fluid_go_on_to_the_bit) {
  for (const double when : {0.0, 0.1, 0.25, 0.4}) stop_and_go_on(dense_fluid, when, 0.6);
}

TEST(Archives, of_a_ball_in_lasting_contact_go_on_to_the_bit) {
  const auto probe = roller();
  Recorder none;
  int rolling = 0;
  for (int i = 1; i <= 30; ++i) {
    const double before = probe->energy_balance().contact_time;
    probe->advance(0.1 * i, none);
    rolling += probe->energy_balance().contact_time > before;
    stop_and_go_on(roller, 0.1 * i, 0.1 * i + 0.5);
  }
  EXPECT_GT(rolling, 5) << "it was in contact";
}

TEST(Archives, cut_short_or_too_long_are_refused) {
  for (const Make& make : {many(capsule(), 2, 0.003), Make(roller)}) {
    const auto engine = make();
    Recorder none;
    engine->advance(0.05, none);
    Archive out;
    engine->serialize(out);
    for (std::size_t size = 0; size < out.bytes().size(); size += 1 + size / 50) {
      Archive in(out.bytes().substr(0, size));
      EXPECT_THROW(make()->serialize(in), RunError) << size;
    }
    Archive in(out.bytes() + "x");
    make()->serialize(in);
    EXPECT_THROW(in.finish(), RunError);
  }
}

/// Damages counts, ball numbers and memory positions of an archive. None of them causes a read out
/// of bounds. (A changed speed gives another valid run and cannot be detected.)
TEST(Archives, with_damaged_numbers_throw_run_errors_and_nothing_else) {
  const Make make = many(capsule(), 2, 0.003, true);
  const auto engine = make();
  Recorder none;
  engine->advance(0.05, none);
  Archive out;
  engine->serialize(out);
  Random random(5, 0);
  int refused = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string bytes = out.bytes();
    const auto at =
        static_cast<std::size_t>(random.uniform() * static_cast<double>(bytes.size() / 4)) * 4;
    const auto damage = static_cast<std::uint32_t>(random.uniform() * 0x1p32);
    std::memcpy(&bytes[at], &damage, sizeof damage);
    Archive in(bytes);
    const auto other = make();
    try {
      other->serialize(in);
      in.finish();
    } catch (const RunError&) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 0);
}

TEST(Cuts, an_engine_is_never_told_to_be_before_the_time_it_was_asked_for) {
  // A caller that advances until the requested time would never finish if the engine's clock, which
  // starts again in every period of the mill, rounded that time down.
  Random random(5, 0);
  for (const double f : {16.6555184, 17.1237458, 10.0, 13.7}) {
    const auto engine = event::one_ball(mill_a(f), ball_a({}, {0.1, 0.02, 0.3}), rules_a(), 0.1);
    Recorder all;
    double time = 0;
    for (int i = 0; i < 20000; ++i) {
      time += random.uniform(0, 1e-3);
      engine->advance(time, all);
      ASSERT_GE(engine->energy_balance().time, time) << f << " Hz, " << i;
    }
  }
}

}  // namespace
}  // namespace mahlwerk::tests::cuts_test
