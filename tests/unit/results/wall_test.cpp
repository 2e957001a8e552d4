// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every hit and every piece of wall is in exactly one cell of the wall, and the wear of all cells
// is the wear of the jar.
#include "mahlwerk/results/quantities/wall.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/observe/collision_batch.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "mahlwerk/results/quantities/summarise.hpp"
#include "meshes.hpp"
#include "statement.hpp"
#include "unit/results/table_of.hpp"

namespace mahlwerk::results::wall_test {
namespace {

using geometry::AnyShape;
using observe::WallGrid;
using tests::states;
using tests::stays_below;

constexpr double pi = std::numbers::pi;

std::vector<AnyShape> shapes() {
  geometry::LifterCylinder drum;
  drum.diameter = 0.2, drum.height = 0.1, drum.lifters = 8;
  drum.lifter_height = 0.012, drum.lifter_width = 0.02, drum.lifter_face_angle = 70 * pi / 180;
  drum.complete();
  geometry::Attritor stirred;
  stirred.diameter = 0.1, stirred.height = 0.12, stirred.shaft_diameter = 0.02;
  stirred.shaft_clearance = 0.01, stirred.arms = 4, stirred.arm_diameter = 0.008;
  stirred.arm_span = 0.08, stirred.arm_clearance = 0.02, stirred.arm_spacing = 0.02;
  stirred.rotor_speed = 30;
  stirred.complete();
  return {geometry::Capsule{0.012, 0.036},
          geometry::Sphere{0.03},
          geometry::Cylinder{0.042, 0.0325},
          geometry::RoundedCylinder{0.042, 0.0325, 0.006},
          geometry::Box{0.03, 0.042, 0.0325},
          geometry::PeriodicBox{0.03, 0.042, 0.0325},
          drum,
          stirred,
          tests::mesh_of(tests::lumpy(0.02))};
}

/// Shapes that wear: a periodic box has no wall.
std::vector<AnyShape> walls() {
  std::vector<AnyShape> list = shapes();
  std::erase_if(list,
                [](const AnyShape& s) { return std::holds_alternative<geometry::PeriodicBox>(s); });
  return list;
}

cases::Case case_of(const AnyShape& shape) {
  cases::Case c;
  c.jar.shape = shape;
  c.jar.substance.hardness = 500;
  c.balls = {{3, 2e-3, 7850, "", {}, {.hardness = 800}}, {2, 1e-3, 6000, "", {}}};
  c.contact.rule = {.restitution = 0.8, .tangential_restitution = 0, .friction = 0.4};
  c.observe.threshold = 0.1;
  c.run.time = 10;
  return c;
}

/// `count` hits at random places of the wall, drawn by area, and as many between balls.
std::vector<scene::Collision> hits(const AnyShape& shape, int count) {
  std::vector<std::array<Vec3, 3>> triangles;
  for (const JarMesh& mesh : jar_surface(shape))
    for (const auto& [a, b, c] : mesh.triangles)
      triangles.push_back({mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
  Random random(8, 0);
  std::vector<scene::Collision> list;
  const int faces = geometry::faces(shape);
  for (int i = 0; i < count; ++i) {
    scene::Collision c;
    const auto& t = triangles[static_cast<std::size_t>(random.uniform() *
                                                       static_cast<double>(triangles.size()))];
    const double u = random.uniform(), v = random.uniform() * (1 - u);
    const Vec3 across = cross(t[1] - t[0], t[2] - t[0]);
    c.where = t[0] + u * (t[1] - t[0]) + v * (t[2] - t[0]);
    c.normal = across / norm(across);
    c.ball = static_cast<std::int32_t>(random.uniform(0, 5));
    c.other = i % 2 == 0 ? ~static_cast<std::int32_t>(random.uniform(0, std::max(1, faces)))
                         : (c.ball + 1) % 5;
    c.mass = random.uniform(0.001, 0.002);
    c.approach = random.uniform(0, 2);
    c.slip = random.uniform(0, 2);
    c.lost_normal = random.uniform(0, 1e-3);
    c.lost_tangential = random.uniform(0, 1e-3);
    list.push_back(c);
  }
  return list;
}

Outcome outcome_of(const AnyShape& shape, int count) {
  Outcome outcome;
  outcome.mill_case = case_of(shape);
  outcome.replicates = {empty_replicate(outcome.mill_case)};
  outcome.replicates[0].tally.collisions(hits(shape, count));
  outcome.replicates[0].energy_balance.time = 10;
  return outcome;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

TEST(WallMap, cells_sum_to_all_hits_with_the_jar) {
  for (const AnyShape& shape : shapes()) {
    const std::string name(geometry::name_of(shape));
    const Outcome outcome = outcome_of(shape, 20000);
    const observe::CollisionStatistics& tally = outcome.replicates[0].tally;
    std::int64_t count = 0;
    double energy = 0, lost = 0, with_jar = 0, lost_with_jar = 0;
    for (int cell = 0; cell < WallGrid::cells; ++cell) {
      count += tally.wall_map[cell].count;
      energy += tally.wall_map[cell].energy_normal;
      lost += tally.wall_map[cell].lost;
    }
    for (int pair = 0; pair < tally.by_pair.pairs(); ++pair)
      if (tally.by_pair.kinds_of(pair).with_jar()) {
        with_jar += tally.by_pair[pair].spectra.energy_normal.sum();
        lost_with_jar += tally.by_pair[pair].spectra.energy_lost.sum();
      }
    EXPECT_EQ(count, 10000) << name;
    EXPECT_EQ(count, tally.all.count - tally.all.between_balls) << name;
    const std::string why = "1e4 roundings of 1e-16, mostly cancelling";
    states(name + ": energy of all cells over that of all pairs", energy / with_jar, 1, 1e-12, why);
    states(name + ": loss, likewise", lost / lost_with_jar, 1, 1e-12, why);
  }
}

TEST(WallMap, areas_of_cells_sum_to_the_area_of_the_wall) {
  for (const AnyShape& shape : shapes()) {
    const std::vector<double> areas =
        wall_areas(shape, empty_replicate(case_of(shape)).tally.wall_map.grid());
    states(std::string(geometry::name_of(shape)) + ": cells over the wall",
           sum(areas) / wall_area(shape), 1, 1e-12, "halved triangles keep their area");
  }
  const double facet = 2 * pi / 96, side = std::sin(facet / 2) / (facet / 2),
               end = std::sin(facet) / facet;
  const geometry::Cylinder drum{0.042, 0.0325};
  states("cylinder: area over that of its polygon",
         wall_area(drum) / (pi * drum.diameter * drum.height * side +
                            0.5 * pi * drum.diameter * drum.diameter * end),
         1, 1e-12, "96 corners");
  // A band of facets between two circles of radii r1, r2 consists of trapezia. Their width is
  // shorter than the arc by the same factor as the polygon's side, their height is at most the
  // chord of a facet.
  const auto below = [&](const std::string& name, double found, double whole) {
    const double least = side * std::pow(std::cos(facet / 2), 2);
    states(name + ": area over its own", found / whole, 0.5 * (1 + least), 0.5 * (1 - least),
           "chords for arcs, both ways");
  };
  const double d = 0.03;
  below("sphere", wall_area(geometry::Sphere{d}), pi * d * d);
  below("capsule", wall_area(geometry::Capsule{d, 0.02}), pi * d * d + pi * d * 0.02);
}

TEST(WallMap, areas_are_those_of_the_grid_that_is_asked_for) {
  const geometry::Cylinder drum{0.042, 0.0325};
  const WallGrid own = empty_replicate(case_of(drum)).tally.wall_map.grid();
  const std::vector<double> first = wall_areas(drum, own);
  WallGrid taller = own;
  taller.top *= 2;
  EXPECT_NE(wall_areas(drum, taller), first);
  EXPECT_EQ(wall_areas(drum, own), first);
}

TEST(WallMap, cells_of_a_drum_have_the_areas_of_their_bounds) {
  for (const double height : {0.008, 0.0325, 0.1}) {
    const geometry::Cylinder drum{0.042, height};
    const WallGrid grid = empty_replicate(case_of(drum)).tally.wall_map.grid();
    const std::vector<double> areas = wall_areas(drum, grid);
    double side = 0, disc = 0;
    for (int cell = 0; cell < WallGrid::cells; ++cell) {
      const auto [angle, across] = grid.bounds(cell);
      const bool on_side = WallGrid::part(cell) == WallGrid::Part::side;
      const double own = on_side ? grid.radius * (across[1] - across[0])
                                 : 0.5 * (across[1] * across[1] - across[0] * across[0]);
      const double off = areas[static_cast<std::size_t>(cell)] / (own * (angle[1] - angle[0])) - 1;
      double& worst = on_side ? side : disc;
      worst = tests::max_or_nan(worst, std::abs(off));
    }
    // Facets for arcs: r cos(f/2) / cos^2(x) for r, within a facet's half width x < f/2.
    constexpr double facet = 2 * pi / 96;
    stays_below("side, worst cell, relative", side, 1 / std::cos(facet / 2) - 1,
                "96 corners, cut along the borders of cells");
    stays_below("discs, worst cell, relative", disc, 1.0 / 3,
                "pieces at a ring's borders are a third of a cell long, and half of one at most is "
                "put on the wrong side: a sixth at each of two");
  }
}

/// Part of the wall that a place with the outward normal n belongs to, by the rule (obs.4).
WallGrid::Part part_by_rule(const Vec3& n) {
  if (std::abs(n.z) > std::sqrt(0.5)) return n.z > 0 ? WallGrid::Part::top : WallGrid::Part::bottom;
  return WallGrid::Part::side;
}

TEST(WallMap, every_place_is_within_the_bounds_of_its_cell) {
  for (const AnyShape& shape : shapes()) {
    const WallGrid grid = empty_replicate(case_of(shape)).tally.wall_map.grid();
    int sides = 0, ends = 0;
    for (const scene::Collision& c : hits(shape, 5000)) {
      const int cell = observe::cell_of(grid, c.where, c.normal.z);
      ASSERT_EQ(WallGrid::part(cell), part_by_rule(c.normal)) << geometry::name_of(shape);
      const bool side = WallGrid::part(cell) == WallGrid::Part::side;
      const auto [angle, across] = grid.bounds(cell);
      double turn = std::atan2(c.where.y, c.where.x);
      if (turn < 0) turn += 2 * pi;
      const double place = side ? c.where.z : std::hypot(c.where.x, c.where.y);
      constexpr double known = 1e-7;  // [rad] of the angle (Columns); lengths: 1e-9 of the jar
      EXPECT_TRUE(turn > angle[0] - known && turn < angle[1] + known) << geometry::name_of(shape);
      EXPECT_TRUE(place > across[0] - 1e-9 * grid.radius && place < across[1] + 1e-9 * grid.radius)
          << geometry::name_of(shape) << " " << across[0] << " " << place << " " << across[1];
      (side ? sides : ends)++;
    }
    EXPECT_GT(sides, 100) << geometry::name_of(shape);
    EXPECT_GT(ends, 100) << geometry::name_of(shape);
  }
}

TEST(WallMap, rings_of_a_disc_have_equal_areas) {
  const AnyShape shape = geometry::Cylinder{0.042, 0.0325};
  const WallGrid grid = empty_replicate(case_of(shape)).tally.wall_map.grid();
  const double whole = pi * grid.radius * grid.radius;
  for (int ring = 0; ring < WallGrid::rings; ++ring) {
    const auto r = grid.bounds(WallGrid::side_cells + ring * WallGrid::sectors).across;
    states("ring " + std::to_string(ring) + " over the disc",
           pi * (r[1] * r[1] - r[0] * r[0]) / whole, 1.0 / WallGrid::rings, 1e-12, "obs.4");
  }
}

using WearOf = cases::Wear;

class Wear : public testing::TestWithParam<WearOf::Model> {
 protected:
  static Outcome worn(const AnyShape& shape) {
    Outcome outcome;
    outcome.mill_case = case_of(shape);
    outcome.mill_case.parts.set(WearOf{GetParam(), 2e-4});
    outcome.mill_case.powder = cases::Powder{"", 0.003, {}, {}};
    outcome.replicates.assign(2, empty_replicate(outcome.mill_case));
    outcome.replicates[0].tally.collisions(hits(shape, 400));
    outcome.replicates[1].tally.collisions(hits(shape, 800));
    outcome.replicates[0].energy_balance.time = 10;
    outcome.replicates[1].energy_balance.time = 20;
    return outcome;
  }
  static double named(const Outcome& outcome, const std::string& name) {
    const auto list = summarise(outcome).quantities;
    return std::ranges::find(list, name, &Quantity::name)->value;
  }
};

TEST_P(Wear, of_the_cells_is_that_of_the_jar) {
  for (const AnyShape& shape : walls()) {
    const Outcome outcome = worn(shape);
    const Table map = wall_map(outcome);
    double mass = 0;
    for (const auto& row : map.rows) mass += row[5] * row.back() * outcome.mill_case.jar.density;
    EXPECT_EQ(map.columns[5].name, "area");
    EXPECT_EQ(map.columns.back().name, "wear_depth_rate");
    const std::string name(geometry::name_of(shape));
    const double whole = named(outcome, "wear_rate_jar");
    EXPECT_GT(whole, 0);
    states(name + ": area times depth times density over wear", mass / whole, 1, 1e-9, "wea.1");
  }
}

TEST_P(Wear, of_the_faces_is_that_of_the_jar) {
  for (const AnyShape& shape : walls()) {
    const Outcome outcome = worn(shape);
    const Table table = table_of(outcome, "wear");
    double balls = 0, jar = 0;
    for (std::size_t i = 0; i < table.rows.size(); ++i)
      (i < outcome.mill_case.balls.size() ? balls : jar) += table.rows[i][2];
    const std::string name(geometry::name_of(shape));
    states(name + ": faces over the jar", jar / named(outcome, "wear_rate_jar"), 1, 1e-12, "wea.1");
    states(name + ": sets over the balls", balls / named(outcome, "wear_rate_balls"), 1, 1e-12,
           "wea.1");
  }
}

/// Expected values directly from the records: the loss of every body in every collision.
TEST_P(Wear, and_contamination_are_those_written_by_hand) {
  const AnyShape shape = geometry::Cylinder{0.042, 0.0325};
  const Outcome outcome = worn(shape);
  const std::vector<scene::Collision> list = hits(shape, 800);
  const auto rate = [&](int count, double time) {
    double mass = 0;
    for (int i = 0; i < count; ++i) {
      const scene::Collision& c = list[static_cast<std::size_t>(i)];
      const double u2 = c.approach * c.approach + c.slip * c.slip,
                   a = std::atan2(c.approach, c.slip);
      const double f = std::tan(a) <= 1.0 / 3 ? std::sin(2 * a) - 3 * std::pow(std::sin(a), 2)
                                              : std::pow(std::cos(a), 2) / 3;
      const double by =
          GetParam() == WearOf::Model::archard ? c.lost_tangential / 0.4 : c.mass * u2 * f;
      const auto of_ball = [](int ball) { return ball < 3 ? 7850 / 800.0 : 6000 / 600.0; };
      mass += 2e-4 * by / 9.80665e6 *
              (of_ball(c.ball) +
               (c.other < 0 ? cases::hardened_steel_density / 500 : of_ball(c.other)));
    }
    return mass / time;
  };
  const double wanted = 0.5 * (rate(400, 10) + rate(800, 20)) / 0.003 * 1e6 * 3600;
  states("contamination over that by hand", named(outcome, "contamination_rate") / wanted, 1, 1e-12,
         "wea.2, wea.3, wea.4, wea.6, wea.7");
}

INSTANTIATE_TEST_SUITE_P(Models, Wear,
                         testing::Values(WearOf::Model::archard, WearOf::Model::finnie),
                         [](const auto& of) {
                           return of.param == WearOf::Model::archard ? "archard" : "finnie";
                         });

}  // namespace
}  // namespace mahlwerk::results::wall_test
