// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Position and motion of the charge: distributing mass over cells conserves mass, centre, momentum
// and energy.
#include "mahlwerk/observe/charge.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "statement.hpp"

namespace mahlwerk::observe::charge_test {
namespace {

using tests::states;
using tests::stays_below;

constexpr double pi = std::numbers::pi;

scene::Chamber planetary(double ratio) {
  kinematics::Planetary mill;
  mill.orbit_radius = 0.07;
  mill.speed = 40;
  mill.ratio = ratio;
  return {geometry::Cylinder{0.042, 0.03}, mill, {}, {0, 0, -9.81}};
}
scene::Chamber drum(double speed) {
  return {geometry::Cylinder{0.2, 0.1},
          kinematics::Tumbling{speed},
          scene::mounted_along(kinematics::Tumbling::jar_axis),
          {0, 0, -9.81}};
}

std::vector<scene::Ball> random_balls_in(double within, int count) {
  Random random(3, 0);
  std::vector<scene::Ball> balls;
  for (int i = 0; i < count; ++i)
    balls.push_back({random.uniform(1e-3, 3e-3), 7850,
                     within * random.uniform() * random.direction(),
                     random.uniform() * random.direction(), 10 * random.direction()});
  return balls;
}

/// Sums over a field: mass, first moments, momentum, kinetic energy of translation.
struct Held {
  double mass = 0, x = 0, y = 0, px = 0, py = 0, energy = 0;
};
Held held(const PlaneField& field) {
  Held sum;
  const double width = 2 * field.half() / PlaneField::cells;
  for (int j = 0; j < PlaneField::cells; ++j)
    for (int i = 0; i < PlaneField::cells; ++i) {
      const double m = field.density(i, j) * field.cell_area();
      sum.mass += m;
      sum.x += m * ((i + 0.5) * width - field.half());
      sum.y += m * ((j + 0.5) * width - field.half());
      sum.px += m * field.velocity_x(i, j);
      sum.py += m * field.velocity_y(i, j);
      sum.energy += field.kinetic_energy(i, j) * field.cell_area();
    }
  return sum;
}

TEST(Fields, hold_the_charges_mass_middle_momentum_and_energy) {
  Charge charge(drum(0), 0.1);
  const auto balls = random_balls_in(0.09, 200);
  Held wanted;
  for (const scene::Ball& b : balls) {
    const double m = b.mass();
    wanted.mass += m;
    wanted.x += m * dot(b.position, charge.right());
    wanted.y += m * dot(b.position, charge.up());
    wanted.px += m * dot(b.velocity, charge.right());
    wanted.py += m * dot(b.velocity, charge.up());
    wanted.energy += 0.5 * m * squared(b.velocity);
  }
  for (const double weight : {0.1, 0.3, 0.05}) charge.sample(0, balls, weight);
  for (const auto* field : {&charge.in_jar, &charge.in_carrier}) {
    const Held found = held(*field);
    const std::string why = "obs.5; some thousand roundings of 1e-16";
    states("mass over that of the balls", found.mass / wanted.mass, 1, 1e-12, why);
    states("middle, x [m]", found.x / found.mass, wanted.x / wanted.mass, 1e-13, why);
    states("middle, y [m]", found.y / found.mass, wanted.y / wanted.mass, 1e-13, why);
    states("momentum, x, relative", found.px / wanted.px, 1, 1e-11, why);
    states("momentum, y, relative", found.py / wanted.py, 1, 1e-11, why);
    states("energy over that of the balls", found.energy / wanted.energy, 1, 1e-12, why);
  }
  states("mass at all angles over that of the balls",
         std::accumulate(charge.mass_by_angle.begin(), charge.mass_by_angle.end(), 0.0) / 0.45 /
             wanted.mass,
         1, 1e-12, "weights of 0.45 s");
}

/// Seen from above, x points right; seen from below, left. y is up in both.
TEST(Fields, are_seen_from_where_the_axis_of_the_motion_points_to) {
  const auto axes = [](const Vec3& axis) {
    std::vector<kinematics::Sample> samples;
    for (int i = 0; i <= 4; ++i) samples.push_back({0.1 * i, {}, 0.5 * pi * i});
    const Charge charge(
        {geometry::Cylinder{0.2, 0.1}, kinematics::Tabulated(samples, axis), {}, {}}, 0.1);
    return std::pair(charge.right(), charge.up());
  };
  EXPECT_EQ(axes({0, 0, 1}), std::pair(Vec3{1, 0, 0}, Vec3{0, 1, 0}));
  EXPECT_EQ(axes({0, 0, -1}), std::pair(Vec3{-1, 0, 0}, Vec3{0, 1, 0}));
  const auto [right, up] = axes({0.6, 0, 0.8});  // leaning: right is level
  EXPECT_NEAR(norm(right - Vec3{0, 1, 0}), 0, 1e-15);
  EXPECT_NEAR(norm(up - Vec3{-0.8, 0, 0.6}), 0, 1e-15);
  EXPECT_EQ(axes({std::sqrt(1 - 0.89 * 0.89), 0, 0.89}).first, (Vec3{0, 1, 0})) << "still upright";
  EXPECT_EQ(axes({std::sqrt(1 - 0.91 * 0.91), 0, 0.91}).first, (Vec3{1, 0, 0})) << "flat";
}

TEST(Fields, mass_at_the_very_edge_is_not_lost) {
  PlaneField field(1);
  for (const double x : {-1.0, 1.0, -1.5, 0.999})
    for (const double y : {-1.0, 1.0, 7.0}) field.add(x, y, 1, 2, 5, 0.25, 1);
  field.add_time(1);
  states("mass [kg]", held(field).mass, 12 * 0.25, 1e-12, "obs.5");
}

/// A ball that rotates with the jar, sampled through all phases of the mill.
TEST(Fields, a_ball_that_rides_on_the_wall_rests_in_the_jar_and_turns_on_the_disc) {
  for (const double ratio : {-2.5, -1.0, 0.5}) {
    const scene::Chamber mill = planetary(ratio);
    const auto& motion = std::get<kinematics::Planetary>(*mill.motion);
    Charge charge(mill, 0.021);
    constexpr double r = 0.015;
    const Vec3 own{r, 0, 0};  // in the jar's axes
    double fastest = 0, off = 0;
    for (int i = 0; i < 50; ++i) {
      const double t = 0.0123 * i;
      const Vec3 place = motion.rotation(t) * own, spin = motion.spin(t);
      const std::vector<scene::Ball> ball{{2e-3, 7850, place, cross(spin, place), spin}};
      charge.sample(t, ball, 0.01);
      Charge once(mill, 0.021);
      once.sample(t, ball, 0.01);
      for (int k = 0; k < PlaneField::cells * PlaneField::cells; ++k) {
        const int x = k % PlaneField::cells, y = k / PlaneField::cells;
        fastest = std::max(fastest,
                           std::hypot(once.in_jar.velocity_x(x, y), once.in_jar.velocity_y(x, y)));
        if (once.in_carrier.density(x, y) == 0) continue;
        const double speed =
            std::hypot(once.in_carrier.velocity_x(x, y), once.in_carrier.velocity_y(x, y));
        off = tests::max_or_nan(off, std::abs(speed - std::abs(ratio) * motion.speed * r));
      }
    }
    const std::string name = "ratio " + std::to_string(ratio).substr(0, 4);
    stays_below(name + ": speed in the jar [m/s]", fastest, 1e-13, "at rest; rounding");
    stays_below(name + ": speed on the disc less |k| W r [m/s]", off, 1e-13, "relative turning");
    const Held jar = held(charge.in_jar);
    states(name + ": place in the jar, x [m]", jar.x / jar.mass, r, 1e-14, "it stays there");
    states(name + ": place in the jar, y [m]", jar.y / jar.mass, 0, 1e-14, "it stays there");
    states(name + ": energy of flight in the jar [J]", jar.energy, 0, 1e-20, "at rest");
  }
}

TEST(Fields, a_ball_that_rides_on_the_disc_is_at_one_angle_and_place) {
  const scene::Chamber mill = planetary(-2);
  Charge charge(mill, 0.021);
  constexpr double angle = 1.234;
  double mass = 0;
  for (int i = 0; i < 50; ++i) {
    const double t = 0.0123 * i;
    const kinematics::Carrier disc = kinematics::carrier(*mill.motion, t);
    const Vec3 place = disc.rotation * (0.012 * Vec3{std::cos(angle), std::sin(angle), 0});
    const scene::Ball ball{2e-3, 7850, place, cross(disc.spin, place), {}};
    mass = ball.mass();
    charge.sample(t, {ball}, 0.01);
  }
  const Held disc = held(charge.in_carrier);
  states("place on the disc, x [m]", disc.x / disc.mass, 0.012 * std::cos(angle), 1e-14, "obs.5");
  states("place on the disc, y [m]", disc.y / disc.mass, 0.012 * std::sin(angle), 1e-14, "obs.5");
  states("momentum on the disc [N s]", std::hypot(disc.px, disc.py), 0, 1e-16, "at rest there");
  const auto slot = static_cast<std::size_t>(angle / (2 * pi) * Charge::angles);
  states("mass at its angle over all", charge.mass_by_angle[slot] / (0.5 * mass), 1, 1e-13,
         "one place");
}

/// A ball at rest relative to the wall, and a ball held still while the drum turns under it.
TEST(Charge, slip_is_that_of_the_wall_under_the_ball) {
  const scene::Chamber mill = drum(3);
  const auto& motion = std::get<kinematics::Tumbling>(*mill.motion);
  const Vec3 lowest{0, 0, -(0.1 - 2e-3)}, spin = motion.spin(0);
  Charge rides(mill, 0.1), held_still(mill, 0.1), apart(mill, 0.1);
  rides.sample(0.7, {{2e-3, 7850, lowest, cross(spin, lowest), spin}}, 0.5);
  states("slip of one that rides [m/s]", rides.wall_slip / rides.mass_at_wall, 0, 1e-15,
         "no motion");
  held_still.sample(0.7, {{2e-3, 7850, lowest, {}, {}}}, 0.5);
  states("slip under one held still [m/s]", held_still.wall_slip / held_still.mass_at_wall, 3 * 0.1,
         1e-14, "w R");
  apart.sample(0.7, {{2e-3, 7850, 0.99 * lowest, {}, {}}}, 0.5);
  EXPECT_EQ(apart.mass_at_wall, 0) << "half a radius from the wall";
  EXPECT_GT(apart.mass_total, 0);
}

TEST(Charge, merged_or_carried_is_the_same) {
  Charge one(drum(2), 0.1), other(drum(2), 0.1), both(drum(2), 0.1);
  std::vector<scene::Ball> many = random_balls_in(0.09, 20), few = random_balls_in(0.05, 30);
  for (std::vector<scene::Ball>* balls : {&many, &few})  // one at the wall
    balls->push_back({2e-3, 7850, {0, 0, -(0.1 - 2e-3)}, {0.1, 0.2, 0}, {3, 1, 2}});
  one.sample(0.1, many, 0.5);
  other.sample(0.2, few, 0.25);
  both.sample(0.1, many, 0.5);
  both.sample(0.2, few, 0.25);
  Archive out;
  one.serialize(out);
  Charge again(drum(2), 0.1);
  Archive in(out.bytes());
  again.serialize(in);
  in.finish();
  again.merge(other);
  EXPECT_EQ(again.mass_total, one.mass_total + other.mass_total);
  for (PlaneField Charge::*field : {&Charge::in_jar, &Charge::in_carrier}) {
    const Held sum = held(again.*field), wanted = held(both.*field);
    const double scale = wanted.mass;
    states("mass over that of looking at both", sum.mass / wanted.mass, 1, 1e-12, "sums");
    states("energy, likewise", sum.energy / wanted.energy, 1, 1e-12, "sums");
    states("middle [m], likewise", sum.x / scale, wanted.x / scale, 1e-12, "sums");
    states("middle [m], likewise", sum.y / scale, wanted.y / scale, 1e-12, "sums");
    states("velocity [m/s], likewise", sum.px / scale, wanted.px / scale, 1e-12, "sums");
    states("velocity [m/s], likewise", sum.py / scale, wanted.py / scale, 1e-12, "sums");
    EXPECT_EQ((again.*field).time(), 0.75);
  }
  for (double Charge::*sum : {&Charge::mass_at_wall, &Charge::wall_slip, &Charge::spin_squared,
                              &Charge::jar_speed_fourth})
    states("a sum over that of looking at both", again.*sum, both.*sum, 1e-12 * both.*sum, "sums");
  EXPECT_GT(both.wall_slip, 0);
  EXPECT_GT(one.mass_outside, 0);
  EXPECT_EQ(again.mass_outside, one.mass_outside + other.mass_outside) << "each its first sample";
  EXPECT_EQ(again.mass_sought, one.mass_sought + other.mass_sought);
  for (std::size_t i = 0; i < both.mass_by_angle.size(); ++i)
    EXPECT_NEAR(again.mass_by_angle[i], both.mass_by_angle[i], 1e-12 * both.mass_total);
}

}  // namespace
}  // namespace mahlwerk::observe::charge_test
