// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Every hit on a part, and every piece of its surface, is in exactly one cell (obs.23).
#include "mahlwerk/results/quantities/part_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "statement.hpp"
#include "unit/results/fake.hpp"

namespace mahlwerk::results::part_map_test {
namespace {

using observe::PartGrid;
using tests::states;
using tests::stays_below;

constexpr double pi = std::numbers::pi;

std::vector<geometry::AnySolid> solids() {
  geometry::DiscSolid disc{};
  disc.diameter = 0.04, disc.thickness = 0.004;
  geometry::CylinderSolid cylinder{};
  cylinder.diameter = 0.01, cylinder.length = 0.05;
  geometry::BladeSolid blade{};
  blade.length = 0.04, blade.thickness = 0.003, blade.height = 0.011;
  return {disc, cylinder, blade};
}

cases::MachinePart part_of(const geometry::AnySolid& solid) {
  cases::MachinePart part;
  part.body.solid = solid;
  part.name = std::string(name_of(solid));
  return part;
}

Outcome outcome_of(const std::vector<geometry::AnySolid>& solids) {
  Outcome made = fake_outcome();
  for (const geometry::AnySolid& one : solids) made.mill_case.machine_parts.push_back(part_of(one));
  made.replicates.assign(2, empty_replicate(made.mill_case));
  made.replicates[0].energy_balance.time = 10;
  made.replicates[1].energy_balance.time = 20;
  return made;
}

double sum(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// A hit on part `part` of the case, at a random place within its reach, from any direction.
scene::Collision random_hit(Random& random, std::int32_t face) {
  scene::Collision c;
  c.other = ~face;
  c.where = {random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02), random.uniform(-0.02, 0.02)};
  const Vec3 n{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  c.normal = n / norm(n);
  c.mass = 0.002;
  c.approach = random.uniform(0, 2);
  c.slip = random.uniform(0, 2);
  c.lost_normal = random.uniform(0, 1e-3);
  c.lost_tangential = random.uniform(0, 1e-3);
  return c;
}

TEST(PartMap, has_the_area_of_each_solid) {
  const Outcome outcome = outcome_of(solids());
  const auto rates = part_rates(outcome);
  // A circle by 192 chords: its length is short by (pi/192)^2/6 = 4.5e-5, its area by four times
  // that.
  states("disc [m2]", sum(rates[0].area), pi * 0.04 * (0.02 + 0.004), 2e-4 * 3e-3,
         "2 pi r (r + h)");
  states("cylinder [m2]", sum(rates[1].area), pi * 0.01 * (0.005 + 0.05), 2e-4 * 2e-3,
         "2 pi r (r + h)");
  states("blade [m2]", sum(rates[2].area), 2 * (0.04 * 0.003 + 0.04 * 0.011 + 0.003 * 0.011), 1e-15,
         "2 (ab + bc + ca)");
  // The sides of a cylinder that face x and y are a quarter each.
  for (int side = 0; side < PartGrid::bottom; ++side) {
    const PartGrid& grid = rates[1].grid;
    const auto first = rates[1].area.begin() + grid.first(static_cast<PartGrid::Side>(side));
    const auto [columns, rows] = grid.counts(static_cast<PartGrid::Side>(side));
    states(view_name(static_cast<PartGrid::Side>(side)),
           std::accumulate(first, first + columns * rows, 0.0), pi * 0.01 * 0.05 / 4,
           0.02 * pi * 0.01 * 0.05 / 4, "a quarter of the side, borders within a facet of 48");
  }
}

/// The view and the place of a cell, written once more: the axis of the largest component.
std::pair<int, std::array<double, 2>> expected(const scene::Collision& hit) {
  const std::array n{-hit.normal.x, -hit.normal.y, -hit.normal.z},
      p{hit.where.x, hit.where.y, hit.where.z};
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(n[k]) > std::abs(n[axis])) axis = k;
  const std::size_t u = axis == 0 ? 1 : 0, v = axis == 2 ? 1 : 2;
  return {2 * static_cast<int>(axis) + (n[axis] > 0 ? 1 : 0), {p[u], p[v]}};
}

TEST(PartMap, holds_each_hit_in_the_cell_of_its_place_and_direction) {
  const PartGrid grid({-0.02, -0.02, -0.015}, {0.02, 0.02, 0.015});
  Random random(4, 0);
  int near_the_borders = 0;
  for (int i = 0; i < 20000; ++i) {
    const scene::Collision hit = random_hit(random, 0);
    const auto [side, place] = expected(hit);
    const int cell = grid.cell_of(hit.where, -1.0 * hit.normal);
    if (grid.side(cell) != side) {
      ++near_the_borders;  // directions that are nearly the same to two axes
      continue;
    }
    const PartGrid::Bounds b = grid.bounds(cell);
    const double outside = std::max(0.0, std::abs(hit.where.z) - 0.015);
    EXPECT_LE(b.along[0] - 1e-15, place[0]);
    EXPECT_GE(b.along[1] + 1e-15, place[0]);
    const double beyond = side < PartGrid::bottom ? outside : 0;  // z is across: in the last cell
    EXPECT_LE(b.across[0] - beyond - 1e-15, place[1]);
    EXPECT_GE(b.across[1] + beyond + 1e-15, place[1]);
  }
  stays_below("share of directions that a neighbouring view has", near_the_borders / 20000.0, 3e-3,
              "normals within 0.001 of equal components");
}

TEST(PartMap, cells_sum_to_the_hits_on_each_part) {
  Outcome outcome = outcome_of(solids());  // of one face each
  const int jar_faces = outcome.replicates[0].tally.wall_map.grid().faces;
  Random random(5, 0);
  std::vector<double> count(3), lost(3);
  for (Replicate& r : outcome.replicates) {
    std::vector<scene::Collision> hits = fake_collisions(100);  // with the jar
    for (int i = 0; i < 3000; ++i) {
      const std::int32_t part = i % 3;
      hits.push_back(random_hit(random, jar_faces + part));
      const auto k = static_cast<std::size_t>(part);
      count[k] += 1 / (2 * r.energy_balance.time);
      lost[k] += hits.back().lost() / (2 * r.energy_balance.time);
    }
    r.tally.collisions(hits);
  }
  const auto rates = part_rates(outcome);
  ASSERT_EQ(rates.size(), 3U);
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string name = outcome.mill_case.machine_parts[k].name;
    states(name + ": hits per second", sum(rates[k].rate), count[k], 1e-9 * count[k], "drawn");
    states(name + ": power lost [W]", sum(rates[k].lost), lost[k], 1e-9 * lost[k], "drawn");
  }
  // Packed and merged, they are the same.
  Replicate again = empty_replicate(outcome.mill_case);
  Replicate& whole = outcome.replicates[0];
  whole.pack();
  again.tally.merge(whole.tally);
  for (int cell = 0; cell < rates[0].grid.cells(); ++cell)
    EXPECT_EQ(again.tally.part_maps[0][cell].lost, whole.tally.part_maps[0][cell].lost);
}

}  // namespace
}  // namespace mahlwerk::results::part_map_test
