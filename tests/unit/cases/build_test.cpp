// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/build.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::cases::build_test {
namespace {

using namespace sample;
constexpr double pi = std::numbers::pi;

double value(const std::string& text, std::string_view name,
             const std::vector<Override>& overrides = {}) {
  for (const DerivedQuantity& c : derived_quantities(read_sample(text, overrides)))
    if (c.name == name) return c.value;
  return std::numeric_limits<double>::quiet_NaN();
}

TEST(Consequences, of_paper_a_s_mill) {
  EXPECT_NEAR(value(vial, "peak_wall_speed"), 2 * pi * 10 * 0.025, 1e-12);
  EXPECT_NEAR(value(vial, "acceleration_number"), 10.1, 0.05);  // physics sheet, 10 Hz and 25 mm
  EXPECT_NEAR(value(vial, "acceleration_number", {{"mill.frequency", "25 Hz"}}), 62.9, 0.05);
  EXPECT_NEAR(value(vial, "expected_impact_energy"), 2.60e-3, 5e-6);
  EXPECT_NEAR(value(vial, "ball_mass"), 2.1044e-3, 5e-8);
  EXPECT_NEAR(value(vial, "jar_volume"), 5e-6, 1e-17);
  EXPECT_NEAR(value(vial, "filling"), 5.362, 1e-3);
  EXPECT_TRUE(std::isnan(value(vial, "critical_speed")));
}

TEST(Consequences, of_a_planetary_mill) {
  EXPECT_EQ(value(planetary, "speed_ratio_relative"), -2);
  EXPECT_EQ(value(planetary, "speed_ratio_absolute"), -1);
  EXPECT_NEAR(value(planetary, "critical_speed_ratio"), 3.277, 5e-4);
  // 1 + sqrt(70/13.5 sqrt(1 + 1/0.5^2)); without friction there is no such ratio.
  EXPECT_NEAR(value(planetary, "critical_speed_ratio_with_friction", {{"contact.friction", "0.5"}}),
              4.405, 5e-4);
  EXPECT_TRUE(std::isnan(
      value(planetary, "critical_speed_ratio_with_friction", {{"contact.friction", "0"}})));
  EXPECT_NEAR(value(planetary, "expected_impact_energy"), 26.9e-3, 0.05e-3);  // with absolute speed
  EXPECT_NEAR(value(planetary, "relative_centrifugal_acceleration", {{"mill.speed", "800 rpm"}}),
              50.1, 0.05);
  const double disc = 400 * 2 * pi / 60;
  EXPECT_NEAR(value(planetary, "peak_wall_speed"), disc * (0.07 + 0.021), 1e-9);
  EXPECT_NEAR(value(planetary, "filling"), 19.6, 0.05);
  EXPECT_NEAR(value(planetary, "ball_to_powder"), 70, 1e-9);
  EXPECT_EQ(value(planetary, "expected_impact_energy", {{"mill.ratio", "-3.3"}}), 0);  // pinned
  EXPECT_GT(value(planetary, "expected_impact_energy", {{"mill.ratio", "-3.2"}}), 0);
}

TEST(Consequences, of_a_drum) {
  EXPECT_NEAR(value(drum, "critical_speed"), 42.30 / std::sqrt(0.2 - 0.02), 0.01);
  EXPECT_NEAR(value(drum, "percent_of_critical"), 75, 1e-9);
  const double mass = pi / 6 * 8e-6 * 7850;
  EXPECT_NEAR(value(drum, "expected_impact_energy"), mass * 9.81 * 0.18, 1e-9);
  EXPECT_NEAR(value(drum, "peak_wall_speed"), 0.75 * value(drum, "critical_speed") * pi / 30 * 0.1,
              1e-12);
  EXPECT_EQ(value(drum, "ball_count"), 2);
}

TEST(Consequences, every_name_has_a_sentence) {
  for (const std::string& text : {vial, planetary, drum})
    for (const DerivedQuantity& c : derived_quantities(read_sample(text))) {
      EXPECT_FALSE(c.about.empty()) << c.name;
      EXPECT_TRUE(std::isfinite(c.value)) << c.name;
    }
}

TEST(Build, the_chamber_is_the_case_s) {
  const Case c = read_sample(drum, {{"gravity", "5 m/s2"}});
  const scene::Chamber chamber = cases::chamber(c);
  EXPECT_EQ(chamber.gravity, (Vec3{0, 0, -5}));
  EXPECT_EQ(*chamber.shape, *c.jar.shape);
  EXPECT_EQ(*chamber.motion, *c.mill.motion);
  EXPECT_NEAR(norm(chamber.mount * Vec3{0, 0, 1} - Vec3{1, 0, 0}), 0, 1e-15);
}

/// No ball touches the wall or another ball. Positions are in laboratory coordinates.
void expect_free(const Case& c, int replicate) {
  const scene::Chamber chamber = cases::chamber(c);
  const auto balls = starting_balls(c, replicate);
  const Rotation turn = kinematics::rotation(*chamber.motion, 0);
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3 p = chamber.mount.apply_inverse(turn.apply_inverse(balls[i].position));
    std::visit(
        [&](const auto& shape) {
          for (int face = 0; face < shape.faces; ++face)
            if (shape.can_touch(face, balls[i].radius)) {
              EXPECT_GT(shape.gap(face, p).distance, balls[i].radius);
            }
        },
        *chamber.shape);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(norm(balls[i].position - balls[j].position), balls[i].radius + balls[j].radius);
  }
}

TEST(Build, starting_balls_touch_nothing) {
  for (int replicate = 0; replicate < 50; ++replicate) {
    expect_free(read_sample(vial), replicate);
    expect_free(read_sample(planetary), replicate);
    expect_free(read_sample(drum), replicate);
    expect_free(read_sample(vial, {{"balls.diameter", "11.9999 mm"}}), replicate);
    expect_free(read_sample(vial, {{"jar.kind", "rounded-cylinder"}, {"jar.fillet", "5 mm"}}),
                replicate);
    expect_free(read_sample(vial, {{"jar.kind", "sphere"}, {"jar.diameter", "12 mm"}}), replicate);
  }
}

TEST(Build, starting_balls_are_uniform_over_the_free_volume) {
  const Case c = read_sample(vial);  // free volume: a capsule of radius 2 mm, cylinder 36.2 mm
  const double half = 0.5 * std::get<geometry::Capsule>(*c.jar.shape).height;
  const int n = 20000;
  int in_caps = 0, above = 0;
  double r2 = 0;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = starting_balls(c, i).at(0).position;
    in_caps += std::abs(p.z) > half;
    above += p.z > 0;
    if (std::abs(p.z) < half) r2 += p.x * p.x + p.y * p.y;
  }
  const double radius = 2e-3 - 4e-6, caps = 4.0 / 3 * radius / (4.0 / 3 * radius + 2 * half);
  const double deviation = std::sqrt(caps * (1 - caps) / n);
  EXPECT_NEAR(in_caps / double(n), caps, 5 * deviation);
  EXPECT_NEAR(above / double(n), 0.5, 5 * 0.5 / std::sqrt(double(n)));
  EXPECT_NEAR(r2 / (n - in_caps), 0.5 * radius * radius, 0.02 * radius * radius);
}

TEST(Build, starting_speeds_are_paper_a_s_in_the_laboratory) {
  const Case c = read_sample(vial);
  const Vec3 jar = kinematics::frame_motion(*c.mill.motion, 0).velocity;
  double speed = 0, spin = 0;
  const int n = 5000;
  for (int i = 0; i < n; ++i) {
    const scene::Ball b = starting_balls(c, i).at(0);
    const double v = norm(b.velocity + jar), w = norm(b.spin);
    EXPECT_LE(v, 0.1 + 1e-12);
    EXPECT_LE(w, 0.1);
    speed += v / n;
    spin += w / n;
  }
  EXPECT_NEAR(speed, 0.05, 0.002);
  EXPECT_NEAR(spin, 0.05, 0.002);
}

TEST(Build, the_start_depends_on_seed_and_replicate_alone) {
  const Case a = read_sample(vial), b = read_sample(vial, {{"seed", "4"}});
  EXPECT_EQ(starting_balls(a, 2).at(0).position, starting_balls(a, 2).at(0).position);
  EXPECT_NE(starting_balls(a, 2).at(0).position, starting_balls(a, 3).at(0).position);
  EXPECT_NE(starting_balls(a, 2).at(0).position, starting_balls(b, 2).at(0).position);
}

TEST(Build, a_charge_that_cannot_be_placed_says_so) {
  const Case c = read_sample(drum, {{"balls.1.diameter", "19 mm"}, {"balls.1.filling", "0.7"}});
  EXPECT_THROW(starting_balls(c, 0), InputError);
}

}  // namespace
}  // namespace mahlwerk::cases::build_test
