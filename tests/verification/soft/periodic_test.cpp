// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The periodic cylinder: a piece of a long drum. A ball or a charge in it moves as in the long
// drum.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "soft.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::periodic_test {
namespace {

using contact::HertzMindlin;
using contact::Rolling;

constexpr double diameter = 0.05, length = 0.03, radius = 0.003;  // [m]
constexpr std::size_t few = 32, many = 0;                         // limits of the solver for few

template <class Shape>
scene::Chamber drum(const Shape& shape, double speed = 10) {
  return {shape, kinematics::Tumbling{speed}, scene::mounted_along({1, 0, 0}), {0, 0, -gravity}};
}
scene::Chamber periodic_drum(double period = length) {
  return drum(geometry::PeriodicCylinder{diameter, period});
}

contact::Pair usual_pair(double mu = 0.3) {
  contact::Pair pair = pair_of({1e8, 0.3}, {1e8, 0.3}, 0.6, mu);
  pair.rolling_friction = 0.02;
  return pair;
}

std::unique_ptr<scene::Engine> run_in(const scene::Chamber& mill,
                                      const std::vector<scene::Ball>& balls,
                                      const contact::Pair& pair, std::size_t limit = few) {
  const soft::Settings rules{of_law(HertzMindlin{}, Rolling::cdt), 2e-6, false, limit};
  return soft::make_engine(mill, balls, rules,
                           contact::PairTable(1, geometry::faces(*mill.shape), pair), 0);
}

/// Position along the axis in the period about the middle.
double folded(double x, double period = length) {
  return std::remainder(x, period);
}

/// Balls on a lattice that fills the period, with random velocities.
std::vector<scene::Ball> charge(double shift = 0) {
  Random random(3, 0);
  std::vector<scene::Ball> balls;
  for (int i = 0; i < 60; ++i) {
    const Vec3 cell{i % 4 - 1.5, i / 4 % 4 - 1.5, i / 16 - 1.5};
    balls.push_back({radius, 7850, 0.0075 * cell, random.uniform(0, 0.5) * random.direction(), {}});
    balls.back().position.x += shift;
  }
  return balls;
}

TEST(PeriodicCylinder, a_ball_moves_as_in_a_long_drum) {
  // It crosses the end of the period several times while it bounces and rolls on the side.
  const scene::Ball ball{radius, 7850, {0.001, 0.002, 0}, {0.9, 0.3, -0.2}, {20, 30, -10}};
  for (const std::size_t limit : {few, many}) {
    const auto piece = run_in(periodic_drum(), {ball}, usual_pair(), limit);
    const auto whole = run_in(drum(geometry::Cylinder{diameter, 1.2}), {ball}, usual_pair(), limit);
    Recorder of_piece, of_whole;
    piece->advance(0.3, of_piece);
    whole->advance(0.3, of_whole);
    const scene::Ball a = piece->balls()[0], b = whole->balls()[0];
    ASSERT_GT(b.position.x, 3 * length) << "else nothing is compared";
    ASSERT_GT(of_whole.all.size(), 3U);
    EXPECT_EQ(a.velocity, b.velocity) << "the same bits";
    EXPECT_EQ(a.spin, b.spin);
    states("position along the axis [m]", a.position.x, folded(b.position.x), 1e-16,
           "the long drum, modulo the period");
    ASSERT_EQ(of_piece.all.size(), of_whole.all.size());
    for (std::size_t i = 0; i < of_whole.all.size(); ++i) {
      EXPECT_EQ(of_piece.all[i].time, of_whole.all[i].time);
      EXPECT_EQ(of_piece.all[i].impulse, of_whole.all[i].impulse);
      EXPECT_LE(std::abs(of_piece.all[i].where.z), 0.5 * length) << "wall maps end there";
    }
  }
}

TEST(PeriodicCylinder, keeps_the_momentum_along_its_axis_if_the_wall_is_smooth) {
  for (const std::size_t limit : {std::size_t{100}, many}) {
    contact::Pair smooth = usual_pair(0);
    smooth.rolling_friction = 0;
    const auto engine = run_in(periodic_drum(), charge(), smooth, limit);
    const auto along = [&] {
      double sum = 0, size = 0;
      for (const scene::Ball& b : engine->balls())
        sum += b.mass() * b.velocity.x, size += b.mass() * std::abs(b.velocity.x);
      return std::pair(sum, size);
    };
    const auto [before, size] = along();
    Recorder recorder;
    engine->advance(0.1, recorder);
    ASSERT_GT(recorder.all.size(), 100U);
    // 5e4 steps with one rounding of each ball's momentum, of random sign.
    stays_below(limit == many ? "many: change of momentum, of its size"
                              : "few: change of momentum, of its size",
                std::abs(along().first - before) / size, std::sqrt(5e4) * 1.1e-16 * 10,
                "Newton; no force along the axis");
  }
}

TEST(PeriodicCylinder, a_collision_across_the_end_of_the_period_is_that_in_the_middle) {
  for (const std::size_t limit : {few, many})
    for (const double shift : {0.5 * length, -0.5 * length, 2.5 * length}) {
      const std::vector<scene::Ball> pair{
          {radius, 7850, {-1.2 * radius, 0, 0}, {0.5, 0, 0.1}, {0, 40, 0}},
          {radius, 7850, {1.2 * radius, 0.3 * radius, 0}, {-0.4, 0.1, 0}, {10, 0, 20}}};
      std::vector<scene::Ball> shifted = pair;
      for (scene::Ball& b : shifted) b.position.x = folded(b.position.x + shift);
      const auto middle = run_in(periodic_drum(), pair, usual_pair(), limit);
      const auto across = run_in(periodic_drum(), shifted, usual_pair(), limit);
      Recorder of_middle, of_across;
      middle->advance(0.02, of_middle);
      across->advance(0.02, of_across);
      ASSERT_EQ(of_middle.all.size(), 1U);
      ASSERT_EQ(of_across.all.size(), 1U);
      double off = 0;
      for (std::size_t i = 0; i < 2; ++i) {
        const scene::Ball a = middle->balls()[i], b = across->balls()[i];
        off = max_or_nan(off, norm(a.velocity - b.velocity) + radius * norm(a.spin - b.spin));
      }
      // The positions are rounded to 1e-17 of 0.03 m, and a force of Hertz changes by 1.5 times the
      // relative change of the overlap: 1e-17 m of 1e-5 m.
      stays_below("velocities after the collision differ by [m/s]", off, 1e-10,
                  "the same collision half a period away");
    }
}

/// A drum of two periods with the charge and its image moves as the drum of one period.
TEST(PeriodicCylinder, a_charge_moves_as_with_its_image_in_a_drum_of_twice_the_length) {
  const auto run = [](double period, std::vector<scene::Ball> balls, double nudge) {
    balls[0].position.y += nudge;
    const auto engine = run_in(periodic_drum(period), balls, usual_pair(), many);
    Recorder recorder;
    engine->advance(0.03, recorder);
    EXPECT_GT(recorder.all.size(), 60U);
    return engine->balls();
  };
  std::vector<scene::Ball> both = charge(-0.5 * length);
  for (const scene::Ball& b : charge(0.5 * length)) both.push_back(b);
  const auto one = run(length, charge(), 0), two = run(2 * length, both, 0),
             nudged = run(length, charge(), 1e-14);
  double off = 0, grown = 0;
  for (std::size_t i = 0; i < one.size(); ++i) {
    const auto apart = [&](const Vec3& a, const Vec3& b, double shift) {
      return std::hypot(folded(a.x - b.x - shift), a.y - b.y, a.z - b.z);
    };
    off = max_or_nan(off, apart(one[i].position, two[i].position, 0.5 * length));
    off = max_or_nan(off, apart(one[i].position, two[i + one.size()].position, -0.5 * length));
    grown = max_or_nan(grown, apart(one[i].position, nudged[i].position, 0));
  }
  stays_below("positions of the charge and its image [m]", off, std::max(1e-13, 20 * grown),
              "period doubled; growth of a nudge of 1e-14 m");
}

/// The second ball passes the images of the first at 2.6 and 2.1 radii aside, and hits the third,
/// 2.93 periods from where the first ball is.
TEST(PeriodicBox, balls_that_have_drifted_apart_by_periods_collide) {
  const double side = 0.05, speed = 1, drift = 0.5 * radius * speed / side;  // [m], [m/s], [m/s]
  for (const std::size_t limit : {few, many}) {
    const scene::Chamber box{geometry::PeriodicBox{side, side, side}, kinematics::Still{}, {}, {}};
    const std::vector<scene::Ball> balls{
        {radius, 7850, {}, {}, {}},
        {radius, 7850, {0.4 * side, -2.9 * radius, 0}, {speed, drift, 0}, {}}};
    const auto engine = run_in(box, balls, usual_pair(0), limit);
    Recorder recorder;
    engine->advance(2.9 * side / speed, recorder);
    ASSERT_EQ(recorder.all.size(), 1U);
    double wanted = 2.6;  // periods: offset and distance along x make two radii
    for (int k = 0; k < 50; ++k)
      wanted = 2.6 - std::sqrt(4 - std::pow(2.9 - 0.5 * wanted, 2)) * radius / side;
    const double one_step = 2e-6 * speed / side;
    states("distance to the collision over a period", recorder.all[0].time * speed / side, wanted,
           1.5 * one_step, "geometry; times of touch are those of steps");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::periodic_test
