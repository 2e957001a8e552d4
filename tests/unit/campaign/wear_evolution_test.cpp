// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/wear/wear_evolution.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "mahlwerk/campaign/wear/wear_step.hpp"
#include "mahlwerk/campaign/wear/wear_tables.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/geometry/worn_section.hpp"
#include "mahlwerk/results/files/csv.hpp"
#include "statement.hpp"
#include "unit/campaign/runs.hpp"
#include "unit/cases/sample.hpp"

namespace mahlwerk::campaign::wear_evolution_test {
namespace {

using cases::Case;
using cases::sample::read_sample;
using tests::states;

std::string drum(const std::string& jar, const std::string& wear) {
  return R"([mill]
kind = "tumbling"
speed = "90 rpm"
[jar]
)" + jar +
         R"(
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
hardness = 200
density = "7800 kg/m3"
[[balls]]
count = 12
diameter = "8 mm"
density = "7850 kg/m3"
youngs_modulus = "200 GPa"
poisson_ratio = 0.3
hardness = 400
[contact]
restitution = 0.5
friction = 0.4
softening = 1e-3
[wear]
coefficient = 1e-2
)" + wear +
         R"(
[run]
engine = "soft"
time = "0.1 s"
settle = "0.1 s"
replicates = 2
)";
}

const std::string lifters = R"(kind = "periodic-lifter-cylinder"
diameter = "60 mm"
length = "20 mm"
lifters = 6
lifter_height = "5 mm"
lifter_width = "8 mm"
lifter_face_angle = "75 deg")";
const std::string cylinder = "kind = \"cylinder\"\ndiameter = \"60 mm\"\nheight = \"20 mm\"";
const std::string make_up = "make_up = true\nscrap_size = \"4 mm\"\nevolve = \"6000 h\"";

/// The tables of an evolution as texts: the same bits, or not.
std::string bits(const WearEvolution& all) {
  std::string text;
  for (const results::NamedTable& one : wear_tables(all)) text += results::csv(one.table);
  return text;
}

WearEvolution evolved(const Case& c, int threads = 2) {
  WearOptions options;
  options.run = on(threads);
  return evolve_wear(c, options);
}

double area_lost(const WearEvolution& all) {
  return geometry::area_of(all.stages.front().state.sections[0]) -
         geometry::area_of(all.stages.back().state.sections[0]);
}

TEST(WearEvolution, volume_that_lifters_lose_is_their_wear) {
  const WearEvolution all = evolved(read_sample(drum(lifters, "evolve = \"10000 h\"")));
  ASSERT_TRUE(all.complete) << all.stop_reason;
  ASSERT_GT(all.stages.size(), 2U);
  states("time [s]", all.stages.back().state.time, 10'000 * 3600, 0, "evolve, exactly");
  const double worn = all.stages.back().state.lost.parts;
  EXPECT_GT(worn, 0);
  states("volume lost by the profile [m3]", area_lost(all) * 6 * 0.02, worn, 1e-9 * worn,
         "sum of the wear over the stages (wea.12)");
  double rate = 0;  // by the quantity of each stage
  for (const WearStage& s : all.stages) rate += s.wear_rate_parts.value * s.duration;
  states("mass worn off the parts [kg]", rate, 7800 * worn, 1e-9 * rate,
         "wear_rate_parts of the runs times their durations");
  EXPECT_LT(all.stages.back().heights[0], all.fresh_heights[0]);
}

TEST(WearEvolution, a_shell_grows_by_the_volume_that_wore_off) {
  const WearEvolution all = evolved(read_sample(drum(cylinder, "evolve = \"10000 h\"")));
  ASSERT_TRUE(all.complete) << all.stop_reason;
  const WornState& end = all.stages.back().state;
  const auto volume = [](const WornState& s) {
    return std::numbers::pi / 4 * s.diameter * s.diameter * s.height;
  };
  EXPECT_GT(end.diameter, 0.06);
  EXPECT_GT(end.height, 0.02);
  states("volume [m3]", volume(end) - volume(all.stages.front().state), end.lost.jar,
         1e-9 * end.lost.jar, "wear of all faces (wea.18)");
}

TEST(WearEvolution, a_mesh_loses_its_wear) {
  Case c = read_sample(drum(cylinder, "evolve = \"10000 h\""));
  geometry::Section round;
  for (int i = 0; i < 24; ++i) {
    const double at = 2 * std::numbers::pi * i / 24;
    round.push_back({0.03 * std::cos(at), 0.03 * std::sin(at)});
  }
  c.jar.shape = geometry::Mesh(geometry::weld(geometry::prism(round, 0.02, 1)), 0.5);
  const WearEvolution all = evolved(c);
  ASSERT_TRUE(all.complete) << all.stop_reason;
  const WornState &start = all.stages.front().state, &end = all.stages.back().state;
  ASSERT_EQ(end.surfaces.size(), 1U);
  states("volume lost by the mesh [m3]",
         geometry::volume_of(end.surfaces[0]) - geometry::volume_of(start.surfaces[0]),
         end.lost.jar, 1e-6 * end.lost.jar, "wear of the jar (wea.19)");
}

TEST(WearEvolution, make_up_keeps_the_volume_of_the_charge) {
  const WearEvolution all = evolved(read_sample(drum(cylinder, make_up)));
  ASSERT_TRUE(all.complete) << all.stop_reason;
  const WornState &start = all.stages.front().state, &end = all.stages.back().state;
  const double volume = powder::volume_of(start.charges[0]);
  EXPECT_GT(end.charges[0].size(), 2U) << "balls of several ages";
  states("volume of the balls [m3]", powder::volume_of(end.charges[0]), volume, 1e-12 * volume,
         "fresh balls replace what was lost");
  states("volume added [m3]", end.lost.added, end.lost.balls + end.lost.scrapped, 1e-12 * volume,
         "worn off and scrapped");
}

TEST(WearEvolution, without_make_up_balls_lose_their_wear) {
  const WearEvolution all =
      evolved(read_sample(drum(cylinder, "scrap_size = \"1 mm\"\nevolve = \"1000 h\"")));
  const WornState &start = all.stages.front().state, &end = all.stages.back().state;
  const double volume = powder::volume_of(start.charges[0]);
  states("volume of the balls [m3]", powder::volume_of(end.charges[0]), volume - end.lost.balls,
         1e-12 * volume, "less what wore off (wea.13)");
  double mass = 0;
  for (const WearStage& s : all.stages) mass += s.wear_rate_balls.value * s.duration;
  states("mass worn off [kg]", 7850 * end.lost.balls, mass, 1e-9 * mass,
         "wear_rate_balls of the runs times their durations");
}

TEST(WearEvolution, has_the_same_bits_on_any_number_of_threads) {
  const Case c = read_sample(drum(lifters, make_up));
  const WearEvolution one = evolved(c, 1);
  ASSERT_TRUE(one.complete) << one.stop_reason;
  EXPECT_EQ(bits(one), bits(evolved(c, 3)));
}

TEST(WearEvolution, that_was_interrupted_goes_on_after_the_last_stage_that_ended) {
  const Case c = read_sample(drum(lifters, make_up));
  const std::string whole = bits(evolved(c));
  std::string kept;
  std::atomic<bool> stop = false;
  std::vector<std::size_t> begun;
  WearOptions options;
  options.run = on(2);
  options.run.stop = &stop;
  options.keep = [&](std::string state) { kept = std::move(state); };
  options.begin = [&](std::size_t stage, double) {
    begun.push_back(stage);
    stop = stage == 2;
  };
  const WearEvolution part = evolve_wear(c, options);
  EXPECT_FALSE(part.complete);
  EXPECT_EQ(part.stages.size(), 2U);
  stop = false;
  begun.clear();
  options.begin = [&](std::size_t stage, double) { begun.push_back(stage); };
  options.kept = kept;
  EXPECT_EQ(bits(evolve_wear(c, options)), whole) << "the same bits as without an interruption";
  ASSERT_FALSE(begun.empty());
  EXPECT_EQ(begun.front(), 2U) << "stages that ended are not run again";
}

/// The error of a shell that wears evenly, after a time in so many steps: D' = 2 k.
double shell_error(int steps) {
  const WornCase of(read_sample(drum(cylinder, "evolve = \"1 h\"")));
  constexpr double rate = 1e-6, time = 3600;  // [m/s], [s]
  WornState state = of.fresh();
  for (int i = 0; i < steps; ++i) {
    WearRates rates;
    rates.shell = rate * std::numbers::pi * state.diameter * state.height;
    rates.balls = {{0}};
    state = *worn_after(of, state, rates, time / steps);
  }
  return state.diameter - (0.06 + 2 * rate * time);
}

TEST(WearEvolution, half_the_step_halves_the_error) {
  states("ratio of the errors of a shell", shell_error(20) / shell_error(40), 2, 0.05,
         "Euler's method (wea.10)");
}

TEST(WearEvolution, lifters_of_a_drum_become_a_part_of_the_same_outline) {
  const Case c = read_sample(drum(lifters, "evolve = \"1 h\""));
  const WornCase of(c);
  const Case stage = of.at(of.fresh());
  ASSERT_EQ(stage.machine_parts.size(), 1U);
  EXPECT_EQ(stage.machine_parts[0].name, "lifters");
  const auto& solid = std::get<geometry::MeshSolid>(*stage.machine_parts[0].body.solid);
  const auto* bars = geometry::as<geometry::PeriodicLifterCylinder>(*c.jar.shape);
  double worst = 0;
  for (int i = 0; i < 400; ++i) {
    const double at = 0.0157 * i, r = 0.012 + 0.00004 * i;
    const Vec3 p{r * std::cos(at), r * std::sin(at), 0};
    double nearest = 1;
    for (int face = 1; face < bars->faces; ++face)
      nearest = std::min(nearest, bars->gap(face, p).distance);
    worst = std::max(worst, std::abs(nearest - solid.clearance(p)));
  }
  states("distance to a lifter, by both [m]", worst, 0, 1e-12, "geometry of the jar (geo.13)");
  states("height [m]", of.profiles()[0].height, 5e-3, 1e-15, "lifter_height");
}

}  // namespace
}  // namespace mahlwerk::campaign::wear_evolution_test
