// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Energy balance of every jar shape with every mill motion.
#include <gtest/gtest.h>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "one_ball.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::energy_test {
namespace {

TEST(Energy, elastic_runs_conserve_it_over_five_thousand_collisions) {
  for (const double e_t : {1.0, -1.0}) {
    scene::Chamber still = mill_a();
    still.motion = kinematics::Still{};
    still.mount = scene::mounted_along({0.6, 0, 0.8});
    event::Rules rules;
    rules.bounce = {1, e_t, INFINITY};
    const auto engine =
        event::one_ball(still, ball_a({0.001, 0, 0.002}, {0.5, -0.3, 0.8}, {10, 20, -30}), rules);
    Recorder recorder;
    for (double t = 1; recorder.all.size() < 5000; ++t) engine->advance(t, recorder);
    const scene::EnergyBalance a = engine->energy_balance();
    const double energy = 0.5 * ball_a().mass() * (0.25 + 0.09 + 0.64);
    stays_below("drift over " + std::to_string(a.collisions) + " collisions, relative",
                std::abs(a.kinetic + a.potential - a.initial_energy) / energy, 1e-12,
                e_t == 1 ? "smooth, e_n = 1" : "perfectly rough, e_n = 1");
  }
}

struct Mills {
  std::vector<geometry::AnyShape> shapes{vial(0.012), geometry::Cylinder{0.042, 0.0325},
                                         geometry::RoundedCylinder{0.042, 0.0325, 0.006},
                                         geometry::Sphere{0.03}, geometry::Box{0.03, 0.04, 0.02}};
  std::vector<kinematics::AnyMotion> motions() const {
    using namespace kinematics;
    Vibration tilted = shaken(15, 0.02);
    tilted.tilt = 0.5;
    Circular circle;
    circle.radius = 0.017, circle.speed = 100;
    std::vector<Sample> samples;
    for (int i = 0; i <= 16; ++i)
      samples.push_back({0.01 * i, {0, 0.01 * std::sin(std::numbers::pi * i / 8), 0}, 0.2 * i});
    samples.back().centre = samples.front().centre;
    return {Still{},
            tilted,
            Planetary{.orbit_radius = 0.07, .speed = 41.9, .ratio = -2},
            Tumbling{.speed = 10},
            ArcShaker{.frequency = 20, .arm = 0.12, .swing = 0.08},
            FigureEight{.frequency = 17,
                        .stroke_along = 0.03,
                        .stroke_across = 0.012,
                        .rock = 0.2,
                        .pivot = 0.05},
            circle,
            Tabulated(samples)};
  }
};

/// Every shape with every motion, including inelastic collapse into sustained contacts, sliding and
/// rolling.
TEST(Energy, account_closes_for_every_shape_on_every_motion) {
  const Mills mills;
  double worst_collision = 0, worst_run = 0;
  std::int64_t collisions = 0, lasting = 0;
  std::uint32_t stream = 0;
  for (const auto& shape : mills.shapes)
    for (const auto& motion : mills.motions())
      for (const double e : {0.9, 0.4}) {
        Random random(9, ++stream);
        const Vec3 axis =
            std::visit([](const auto& m) { return std::decay_t<decltype(m)>::jar_axis; }, motion);
        const scene::Chamber mill{shape, motion, scene::mounted_along(axis), {0, 0, -gravity}};
        event::Rules rules = rules_a(e);
        if (stream % 3 == 0) rules.bounce = {e, 0.0, 0.3};
        const auto engine = event::one_ball(
            mill, ball_a({}, 0.5 * random.direction(), 5.0 * random.direction()), rules);
        Recorder recorder;
        engine->advance(2, recorder);
        const scene::EnergyBalance a = engine->energy_balance();
        collisions += a.collisions;
        lasting += a.lasting_contacts;
        worst_collision = max_or_nan(worst_collision, a.worst_collision);
        const double turnover = a.initial_energy + std::abs(a.wall_work) + a.lost();
        const double relative = std::abs(a.residual()) / turnover;
        EXPECT_LT(relative, 1e-5) << shape.index() << " on " << motion.index() << ", e " << e;
        worst_run = max_or_nan(worst_run, relative);
        const scene::Ball b = engine->balls().front();
        EXPECT_TRUE(finite(b.position) && finite(b.velocity) && finite(b.spin));
      }
  std::printf("    %lld collisions, %lld lasting contacts\n", static_cast<long long>(collisions),
              static_cast<long long>(lasting));
  EXPECT_GT(lasting, 30);
  stays_below("worst collision's balance, relative", worst_collision, 1e-9,
              "evt.8, asked of every run");
  stays_below("worst run's balance, relative to the energy turned over", worst_run, 1e-5,
              "evt.18: 1e-8 a step, 1e4 steps, adding up or nearly so");
}

}  // namespace
}  // namespace mahlwerk::tests::energy_test
