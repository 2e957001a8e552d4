// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/part_map.hpp"

#include <algorithm>
#include <array>
#include <iterator>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"
#include "mahlwerk/results/quantities/summed_up.hpp"

namespace mahlwerk::results {
namespace {

using observe::PartGrid;

/// Adds a triangle to the areas [m2] of cells, in pieces that are short against a cell.
void add_area(std::vector<double>& areas, const PartGrid& grid, const std::array<Vec3, 3>& t) {
  constexpr double shortest = 0.5;
  const Halved parts = halved(t);
  if (parts.longest > shortest * grid.edge()) {
    for (const std::array<Vec3, 3>& half : parts.halves) add_area(areas, grid, half);
    return;
  }
  const Vec3 area = area_vector(t);
  if (norm(area) > 0)
    areas[static_cast<std::size_t>(grid.cell_of((1.0 / 3) * (t[0] + t[1] + t[2]), area))] +=
        norm(area);
}

void set_areas(std::vector<PartRates>& rates, const cases::Case& mill_case) {
  constexpr std::uint32_t facets = 192;
  const std::vector<JarMesh> surfaces = own_part_surfaces(cases::chamber(mill_case), facets);
  for (std::size_t k = 0; k < rates.size(); ++k) {
    rates[k].area.assign(rates[k].rate.size(), 0);
    for (const auto& [a, b, c] : surfaces[k].triangles)
      add_area(rates[k].area, rates[k].grid,
               {surfaces[k].vertices[a], surfaces[k].vertices[b], surfaces[k].vertices[c]});
  }
}

}  // namespace

std::vector<PartRates> no_part_rates(const observe::CollisionStatistics& of) {
  std::vector<PartRates> made;
  for (const observe::PartMap& map : of.part_maps)
    made.push_back({HitRates(static_cast<std::size_t>(map.grid().cells())), map.grid()});
  return made;
}

void add_hits(std::vector<PartRates>& rates, const Replicate& replicate, double count) {
  const double per = 1 / (replicate.time() * count);
  for (std::size_t k = 0; k < rates.size(); ++k)
    for (std::size_t i = 0; i < rates[k].rate.size(); ++i)
      rates[k].add(i, replicate.tally.part_maps[k][static_cast<int>(i)], per);
}

std::vector<PartRates> part_rates(const Outcome& outcome) {
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  if (outcome.mill_case.machine_parts.empty() || chosen.empty()) return {};
  const auto count = static_cast<double>(chosen.size());
  std::vector<PartRates> rates =
      outcome.summed_up ? outcome.summed_up->parts : no_part_rates(chosen.front()->tally);
  if (outcome.summed_up && count != outcome.summed_up->expected)
    for (PartRates& one : rates) one.scale(outcome.summed_up->expected / count);
  set_areas(rates, outcome.mill_case);
  for (const Replicate* r : chosen)
    if (!r->read_before) add_hits(rates, *r, count);
  return rates;
}

const char* view_name(PartGrid::Side side) {
  static constexpr std::array names{"minus_x", "plus_x", "minus_y", "plus_y", "minus_z", "plus_z"};
  return names[side];
}

Table part_map(const Outcome& outcome) {
  Table table{{{"part", "1", "its name"},
               {"side", "1", "the direction, along its own axes, that the surface faces"},
               {"along_low", "m", "lower y of cells that face x, else lower x"},
               {"along_high", "m", "upper y of cells that face x, else upper x"},
               {"across_low", "m", "lower y of cells that face z, else lower z"},
               {"across_high", "m", "upper y of cells that face z, else upper z"}},
              {}};
  const cases::Case& c = outcome.mill_case;
  std::ranges::move(hit_columns(), std::back_inserter(table.columns));
  const std::vector<WallColumn> more = wall_columns(c);
  for (const WallColumn& one : more) table.columns.push_back(one.column);
  const std::vector<PartRates> parts = part_rates(outcome);
  for (std::size_t k = 0; k < parts.size(); ++k)
    for (int cell = 0; cell < parts[k].grid.cells(); ++cell) {
      const auto i = static_cast<std::size_t>(cell);
      if (parts[k].area[i] == 0 && parts[k].rate[i] == 0) continue;
      const PartGrid::Bounds b = parts[k].grid.bounds(cell);
      table.rows.push_back({table.columns[0].number_of(c.machine_parts[k].name),
                            table.columns[1].number_of(view_name(parts[k].grid.side(cell))),
                            b.along[0], b.along[1], b.across[0], b.across[1]});
      add_cells(table.rows.back(), c, parts[k], i, c.machine_parts[k].substance.hardness, more);
    }
  return table;
}

}  // namespace mahlwerk::results
