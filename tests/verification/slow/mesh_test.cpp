// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Ten million steps of small grains in tumbling mesh jars with lumps and with bars: no grain leaves
// the jar.
#include <gtest/gtest.h>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mesh_jars.hpp"
#include "statement.hpp"

namespace mahlwerk::tests::mesh_test {
namespace {

TEST(MeshJarSlow, no_grain_leaves_in_ten_million_steps) {
  for (const geometry::Mesh& mesh :
       {mesh_of(lumpy(0.015)), mesh_of(drum_with_lifters(0.03, 0.02, 5, 0.005, 0.001))}) {
    Random random(8, 1);
    const double radius = 0.0003;
    const auto engine = run_in(mesh, kinematics::Tumbling{20}, lying,
                               random_balls_in(mesh, 4, radius, random), 1e-6);
    Recorder recorder;
    ASSERT_NO_THROW(engine->advance(10, recorder));
    const scene::EnergyBalance a = engine->energy_balance();
    EXPECT_GT(recorder.all.size(), 1000U);
    stays_below("deepest overlap, of a radius", a.deepest_overlap, 0.05, "contacts hold");
    stays_below("energy from nowhere, of what was lost", std::abs(a.residual()) / a.lost(), 1e-3,
                "dem.32; what runs may have");
  }
}

}  // namespace
}  // namespace mahlwerk::tests::mesh_test
