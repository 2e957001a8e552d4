// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every jar on every mill, from nearly plastic to nearly elastic collisions: no run ends in
// inelastic collapse, and the energy balance of each run closes.
#include <gtest/gtest.h>

#include <cstdio>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::lasting_grid_test {
namespace {

constexpr double pi = std::numbers::pi, r = 0.005;
const Vec3 upright{0, 0, 1}, lying{1, 0, 0};

struct Mill {
  std::string name;
  kinematics::AnyMotion motion;
  Vec3 axis;
};
std::vector<Mill> mills() {
  std::vector<Mill> all;
  const double critical = std::sqrt(gravity / (0.025 - r));
  for (const double share : {0.2, 0.5, 0.9, 1.2})
    all.push_back({"tumbling at " + std::to_string(share).substr(0, 3),
                   kinematics::Tumbling{.speed = share * critical}, lying});
  all.push_back({"planetary", kinematics::Planetary{.orbit_radius = 0.07, .speed = 40, .ratio = -2},
                 upright});
  all.push_back({"vibration", shaken(12, 0.01), upright});
  all.push_back({"figure eight",
                 kinematics::FigureEight{.frequency = 17.5,
                                         .stroke_along = 0.03,
                                         .stroke_across = 0.012,
                                         .stroke_up = 0.004,
                                         .phase_across = 0.4,
                                         .phase_up = 1.0,
                                         .rock = 0.2,
                                         .phase_rock = -0.3,
                                         .pivot = 0.05},
                 lying});
  all.push_back(
      {"arc shaker", kinematics::ArcShaker{.frequency = 20, .arm = 0.12, .swing = 0.09}, lying});
  kinematics::Circular circular;
  circular.radius = 0.01, circular.speed = 60;
  all.push_back({"circular", circular, upright});
  return all;
}

struct Bounce {
  std::string name;
  contact::BounceRule rule;
  double lasting_friction;
};
std::vector<Bounce> bounces() {
  std::vector<Bounce> all;
  for (const double e : {0.1, 0.3, 0.5, 0.8, 0.95}) {
    const std::string name = "e " + std::to_string(e).substr(0, 4);
    for (const double mu : {0.1, 0.5})
      all.push_back({name + " mu " + std::to_string(mu).substr(0, 3), {e, 0, mu}, mu});
    all.push_back({name + " e_t 0.9", {e, 0.9, INFINITY}, 0.3});
    all.push_back({name + " mu 1e5", {e, 0, 1e5}, 1e5});
  }
  return all;
}

/// Runs `jar` on every mill with every rule for two seconds.
void every_run_ends(const geometry::AnyShape& jar) {
  double worst = 0;
  int runs = 0, stopped = 0;
  for (const Mill& mill : mills())
    for (const Bounce& bounce : bounces()) {
      event::Rules rules;
      rules.bounce = bounce.rule;
      rules.sustained_friction = bounce.lasting_friction;
      rules.rolling_friction = 0.01;
      const scene::Chamber chamber{
          jar, mill.motion, scene::mounted_along(mill.axis), {0, 0, -gravity}};
      const scene::Ball ball{r, 7850, {0.001, 0.002, -0.0013}, {0.03, -0.02, 0.05}, {1, 2, 3}};
      const auto engine = event::one_ball(chamber, ball, rules);
      Recorder recorder;
      ++runs;
      try {
        engine->advance(2, recorder);
      } catch (const RunError& e) {
        ++stopped;
        ADD_FAILURE() << mill.name << ", " << bounce.name << ": " << e.what();
      }
      const scene::EnergyBalance a = engine->energy_balance();
      const double off =
          std::abs(a.residual()) / (std::abs(a.wall_work) + a.lost() + a.initial_energy);
      worst = max_or_nan(worst, off);
      EXPECT_LE(off, 1e-6) << mill.name << ", " << bounce.name;
    }
  std::printf("    %d runs, %d stopped by the guard\n", runs, stopped);
  stays_below("worst balance, relative to the energy turned over", worst, 1e-6, "evt.18");
}

TEST(Grid, no_run_collapses_in_a_flat_cylinder) {
  every_run_ends(geometry::Cylinder{0.05, 0.018});
}
TEST(Grid, no_run_collapses_in_a_box) {
  every_run_ends(geometry::Box{0.05, 0.04, 0.03});
}
TEST(Grid, no_run_collapses_in_a_long_cylinder) {
  every_run_ends(geometry::Cylinder{0.05, 0.06});
}
TEST(Grid, no_run_collapses_in_a_cylinder_with_narrow_fillets) {
  every_run_ends(geometry::RoundedCylinder{0.05, 0.04, 0.003});
}
TEST(Grid, no_run_collapses_in_a_cylinder_with_wide_fillets) {
  every_run_ends(geometry::RoundedCylinder{0.05, 0.04, 0.01});
}
TEST(Grid, no_run_collapses_in_a_capsule) {
  every_run_ends(geometry::Capsule{0.05, 0.03});
}
TEST(Grid, no_run_collapses_in_a_sphere) {
  every_run_ends(geometry::Sphere{0.05});
}

}  // namespace
}  // namespace mahlwerk::tests::lasting_grid_test
