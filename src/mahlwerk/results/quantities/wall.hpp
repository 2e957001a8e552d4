// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/files/csv.hpp"
#include "mahlwerk/results/outcome.hpp"

// Where the jar's wall is hit and worn, and where the charge is: maps.
namespace mahlwerk::results {

/// [m2] of the jar's wall in each cell of the grid; their sum is the wall's area.
std::vector<double> wall_areas(const geometry::AnyShape& shape, const observe::WallGrid& grid);
/// [m2] of the whole wall.
double wall_area(const geometry::AnyShape& shape);

/// What hits on each cell of the wall come to a second, as a mean over the replicates.
struct WallRates {
  observe::WallGrid grid;
  std::vector<double> area;                 ///< [m2]
  std::vector<double> rate;                 ///< [1/s] hits
  std::vector<double> energy_normal, lost;  ///< [W]
  std::vector<double> slid, erosion;        ///< [N m/s], [W]
};
WallRates wall_rates(const Outcome& outcome);

Table wall_map(const Outcome& outcome);  ///< wall_map.csv: a row per cell of the wall
Table fields(const Outcome& outcome);    ///< fields.csv: a row per cell of the plane and frame

/// The charge of all averaged replicates together.
observe::Charge charge_of(const Outcome& outcome);

}  // namespace mahlwerk::results
