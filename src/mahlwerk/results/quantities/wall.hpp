// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <vector>

#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/table.hpp"

// Maps of hits and wear on the jar's wall, and density and velocity fields of the charge.
namespace mahlwerk::results {

/// A triangle's longest edge [m], and the triangles into which a cut through its middle splits it.
struct Halved {
  double longest = 0;
  std::array<std::array<Vec3, 3>, 2> halves;
};
Halved halved(const std::array<Vec3, 3>& triangle);
Vec3 area_vector(const std::array<Vec3, 3>& triangle);  ///< [m2]

/// [m2] Area of the jar's wall in each cell of the grid. Their sum is the wall's area.
std::vector<double> wall_areas(const geometry::AnyShape& shape, const observe::WallGrid& grid);
/// [m2] Area of the whole wall.
double wall_area(const geometry::AnyShape& shape);

/// Hits on each cell of a surface per second: means over the replicates.
struct HitRates {
  std::vector<double> area;                 ///< [m2]
  std::vector<double> rate;                 ///< [1/s] hits
  std::vector<double> energy_normal, lost;  ///< [W] sums of E_n and of losses, per second
  std::vector<double> slid, erosion;        ///< [N m/s], [W] load times distance; (wea.4)

  HitRates() = default;
  explicit HitRates(std::size_t cells)  ///< without hits and areas
      : rate(cells), energy_normal(cells), lost(cells), slid(cells), erosion(cells) {}
  void add(std::size_t cell, const observe::WallSums& sums, double per);
  void scale(double factor);
};
/// Hits on each cell of the jar's wall.
struct WallRates : HitRates {
  observe::WallGrid grid;
};
WallRates wall_rates(const Outcome& outcome);

/// Rates without hits, and without areas.
WallRates no_wall_rates(const observe::WallGrid& grid);
/// Adds the hits of a replicate to means over `count` replicates.
void add_hits(WallRates& rates, const Replicate& replicate, double count);

/// A column that a part adds to wall_map.csv and part_map.csv: its value in a cell of a surface of
/// the given Vickers hardness.
struct WallColumn {
  Column column;
  double (*value)(const cases::Case&, const HitRates&, std::size_t cell, double hardness);
};
std::vector<WallColumn> wall_columns(const cases::Case& mill_case);
/// The columns of the numbers of HitRates, from its area on.
std::vector<Column> hit_columns();
/// A row of them, with those of `more`.
void add_cells(std::vector<double>& row, const cases::Case& mill_case, const HitRates& rates,
               std::size_t cell, double hardness, const std::vector<WallColumn>& more);

Table wall_map(const Outcome& outcome);  ///< wall_map.csv: a row per cell of the wall
Table fields(const Outcome& outcome);    ///< fields.csv: a row per cell of the plane and frame

/// Sum of the charge statistics of all averaged replicates.
observe::Charge charge_of(const Outcome& outcome);

}  // namespace mahlwerk::results
