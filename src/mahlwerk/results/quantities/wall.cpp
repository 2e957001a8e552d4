// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/wall.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <iterator>
#include <memory>
#include <mutex>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/observe/collision_batch.hpp"
#include "mahlwerk/results/quantities/jar_surface.hpp"
#include "mahlwerk/results/quantities/summed_up.hpp"

namespace mahlwerk::results {
namespace {

using observe::PlaneField;
using observe::WallGrid;

using Triangle = std::array<Vec3, 3>;

/// Borders between cells that are planes: normal . p = distance [m].
struct Border {
  Vec3 normal;
  double distance = 0;
};
struct Borders {
  std::vector<Border> side, disc;
};

Borders borders_of(const WallGrid& grid) {
  Borders made;
  const auto through_axis = [](std::vector<Border>& list, int slots) {
    for (int i = 0; i < slots / 2; ++i) {  // a plane is two borders, half a turn apart
      const double angle = 2 * std::numbers::pi * i / slots;
      list.push_back({{-math::sin(angle), math::cos(angle), 0}, 0});
    }
  };
  for (int i = 1; i < WallGrid::along; ++i)
    made.side.push_back({{0, 0, 1}, std::lerp(grid.bottom, grid.top, 1.0 * i / WallGrid::along)});
  through_axis(made.side, WallGrid::around);
  through_axis(made.disc, WallGrid::sectors);
  return made;
}

/// Splits triangles along cell borders and sums their areas by cell.
class AreaSplitter {
 public:
  /// `least` [m]: longest edge of pieces at the borders of rings, which are round.
  AreaSplitter(const WallGrid& grid, double least)
      : areas(WallGrid::cells), grid_(grid), borders_(borders_of(grid)), least_(least) {}

  void add(const Triangle& t) {
    const Vec3 area = area_vector(t);
    if (!(norm(area) > 0)) return;
    axial_ = area.z / norm(area);
    const int cell = cell_at((1.0 / 3) * (t[0] + t[1] + t[2]));
    cut(t, WallGrid::part(cell) == WallGrid::Part::side ? borders_.side : borders_.disc);
  }

  std::vector<double> areas;

 private:
  int cell_at(const Vec3& where) const { return observe::cell_of(grid_, where, axial_); }

  /// Cuts a triangle along the plane borders that it crosses.
  void cut(const Triangle& t, std::span<const Border> borders) {
    for (std::size_t i = 0; i < borders.size(); ++i) {
      std::array<double, 3> off;
      for (std::size_t k = 0; k < 3; ++k)
        off[k] = dot(borders[i].normal, t[k]) - borders[i].distance;
      const double rounding = 1e-12 * grid_.radius;
      const auto [least, most] = std::ranges::minmax(off);
      if (least > -rounding || most < rounding) continue;
      // Finds the corner that is alone on its side of the border.
      std::size_t k = 0;
      while (off[k] * off[(k + 1) % 3] > 0 || off[k] * off[(k + 2) % 3] > 0 || off[k] == 0) ++k;
      const Vec3 &a = t[k], &b = t[(k + 1) % 3], &c = t[(k + 2) % 3];
      const Vec3 ab = a + off[k] / (off[k] - off[(k + 1) % 3]) * (b - a);
      const Vec3 ac = a + off[k] / (off[k] - off[(k + 2) % 3]) * (c - a);
      for (const Triangle& piece : {Triangle{a, ab, ac}, Triangle{ab, b, c}, Triangle{ab, c, ac}})
        cut(piece, borders.subspan(i + 1));
      return;
    }
    halve(t);
  }

  /// Bisects the longest edge until a piece is within one ring or short enough.
  void halve(const Triangle& t) {
    const Vec3 middle = (1.0 / 3) * (t[0] + t[1] + t[2]);
    const Halved parts = halved(t);
    const int cell = cell_at(middle);
    constexpr double inwards = 1e-3;  // corners on the border of two cells are in either
    const auto same = [&](const Vec3& corner) {
      return cell_at(corner + inwards * (middle - corner)) == cell;
    };
    if (WallGrid::part(cell) == WallGrid::Part::side || parts.longest <= least_ ||
        std::ranges::all_of(t, same)) {
      areas[static_cast<std::size_t>(cell)] += norm(area_vector(t));
      return;
    }
    for (const Triangle& half : parts.halves) halve(half);
  }

  WallGrid grid_;
  Borders borders_;
  double least_;
  double axial_ = 0;  // axial component of the unit normal of the current triangle
};

template <class Of>
void for_triangles(const geometry::AnyShape& shape, const Of& of) {
  for (const JarMesh& mesh : jar_surface(shape))
    for (const auto& [a, b, c] : mesh.triangles)
      of(std::array{mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]});
}

const char* part_name(int cell) {
  switch (WallGrid::part(cell)) {
    case WallGrid::Part::side:
      return "side";
    case WallGrid::Part::bottom:
      return "bottom";
    case WallGrid::Part::top:
      return "top";
  }
  return "";
}

std::vector<double> compute_areas(const geometry::AnyShape& shape, const WallGrid& grid) {
  // A third as long as cells, but long enough to limit the number of pieces.
  constexpr double parts = 3, many = 1e6;
  const double cell = 2 * std::numbers::pi * grid.radius / WallGrid::around;
  AreaSplitter splitter(grid, std::max(cell / parts, std::sqrt(wall_area(shape) / many)));
  for_triangles(shape, [&](const Triangle& t) { splitter.add(t); });
  return std::move(splitter.areas);
}

/// A jar and its grid. Areas of the cells are computed at the first request.
struct CachedAreas {
  CachedAreas(const geometry::AnyShape& of, const WallGrid& in) : shape(of), grid(in) {}
  bool matches(const geometry::AnyShape& other, const WallGrid& in) const {
    return grid.radius == in.radius && grid.bottom == in.bottom && grid.top == in.top &&
           shape == other;
  }
  const std::vector<double>& values() {
    std::call_once(once, [&] { areas = compute_areas(*shape, grid); });
    return areas;
  }
  const Indirect<geometry::AnyShape> shape;
  const WallGrid grid;
  std::once_flag once;
  std::vector<double> areas;
};

/// Cache of areas: a result needs them several times, and points of a campaign share a few jars.
std::shared_ptr<CachedAreas> cached_areas(const geometry::AnyShape& shape, const WallGrid& grid) {
  constexpr std::size_t most = 64;
  static std::mutex mutex;
  static std::deque<std::shared_ptr<CachedAreas>> cache;
  const std::lock_guard lock(mutex);
  for (const auto& one : cache)
    if (one->matches(shape, grid)) return one;
  if (cache.size() == most) cache.pop_front();
  return cache.emplace_back(std::make_shared<CachedAreas>(shape, grid));
}

}  // namespace

Vec3 area_vector(const std::array<Vec3, 3>& t) {
  return 0.5 * cross(t[1] - t[0], t[2] - t[0]);
}

Halved halved(const std::array<Vec3, 3>& t) {
  std::size_t longest = 0;
  double length = 0;
  for (std::size_t k = 0; k < 3; ++k)
    if (const double l = norm(t[(k + 1) % 3] - t[k]); l > length) {
      length = l;
      longest = k;
    }
  const Vec3 &a = t[longest], &b = t[(longest + 1) % 3], &c = t[(longest + 2) % 3];
  const Vec3 half = 0.5 * (a + b);
  return {length, {{{a, half, c}, {half, b, c}}}};
}

std::vector<double> wall_areas(const geometry::AnyShape& shape, const WallGrid& grid) {
  return cached_areas(shape, grid)->values();
}

double wall_area(const geometry::AnyShape& shape) {
  double area = 0;
  for_triangles(shape, [&](const std::array<Vec3, 3>& t) { area += norm(area_vector(t)); });
  return area;
}

void HitRates::add(std::size_t cell, const observe::WallSums& sums, double per) {
  rate[cell] += per * static_cast<double>(sums.count);
  energy_normal[cell] += per * sums.energy_normal;
  lost[cell] += per * sums.lost;
  slid[cell] += per * sums.load_distance;
  erosion[cell] += per * sums.erosion;
}

void HitRates::scale(double factor) {
  for (std::vector<double>* one : {&rate, &energy_normal, &lost, &slid, &erosion})
    for (double& value : *one) value *= factor;
}

WallRates no_wall_rates(const observe::WallGrid& grid) {
  return {HitRates(std::size_t{WallGrid::cells}), grid};
}

void add_hits(WallRates& rates, const Replicate& replicate, double count) {
  const double per = 1 / (replicate.time() * count);
  for (std::size_t i = 0; i < rates.rate.size(); ++i)
    rates.add(i, replicate.tally.wall_map[static_cast<int>(i)], per);
}

WallRates wall_rates(const Outcome& outcome) {
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  const auto count = static_cast<double>(chosen.size());
  WallRates rates =
      outcome.summed_up
          ? outcome.summed_up->wall
          : no_wall_rates(chosen.empty() ? WallGrid{} : chosen.front()->tally.wall_map.grid());
  // The replicates that are summed up, as a part of means over `count`.
  if (outcome.summed_up && count != outcome.summed_up->expected)
    rates.scale(outcome.summed_up->expected / count);
  rates.area = wall_areas(*outcome.mill_case.jar.shape, rates.grid);
  for (const Replicate* r : chosen)
    if (!r->read_before) add_hits(rates, *r, count);
  return rates;
}

std::vector<WallColumn> wall_columns(const cases::Case& mill_case) {
  std::vector<WallColumn> all;
  for (const cases::Part* part : cases::parts_of(mill_case))
    if (part->wall_columns != nullptr)
      std::ranges::move(part->wall_columns(), std::back_inserter(all));
  return all;
}

std::vector<Column> hit_columns() {
  return {{"area", "m2", "area of the surface in the cell"},
          {"rate", "1/s", "hits per second"},
          {"power_normal", "W", "sum of m u_n^2/2 of the hits per second"},
          {"power_lost", "W", "power that the hits dissipate"},
          {"slid", "N m/s", "normal force times sliding distance, per second"}};
}

void add_cells(std::vector<double>& row, const cases::Case& mill_case, const HitRates& rates,
               std::size_t cell, double hardness, const std::vector<WallColumn>& more) {
  for (const std::vector<double>* one :
       {&rates.area, &rates.rate, &rates.energy_normal, &rates.lost, &rates.slid})
    row.push_back((*one)[cell]);
  for (const WallColumn& one : more) row.push_back(one.value(mill_case, rates, cell, hardness));
}

Table wall_map(const Outcome& outcome) {
  Table table{{{"part", "1", "part of the wall: the unrolled side, or the discs at its ends"},
               {"angle_low", "rad", "lower angle about the jar's own axis"},
               {"angle_high", "rad", "upper angle about the jar's own axis"},
               {"across_low", "m", "lower height along the axis (side) or radius (disc)"},
               {"across_high", "m", "upper height along the axis (side) or radius (disc)"}},
              {}};
  std::ranges::move(hit_columns(), std::back_inserter(table.columns));
  const std::vector<WallColumn> more = wall_columns(outcome.mill_case);
  for (const WallColumn& one : more) table.columns.push_back(one.column);
  if (averaged_replicates(outcome).empty()) return table;
  const WallRates rates = wall_rates(outcome);
  for (int cell = 0; cell < WallGrid::cells; ++cell) {
    const auto i = static_cast<std::size_t>(cell);
    if (rates.area[i] == 0 && rates.rate[i] == 0) continue;
    const WallGrid::Bounds b = rates.grid.bounds(cell);
    table.rows.push_back({table.columns[0].number_of(part_name(cell)), b.angle[0], b.angle[1],
                          b.across[0], b.across[1]});
    add_cells(table.rows.back(), outcome.mill_case, rates, i,
              outcome.mill_case.jar.substance.hardness, more);
  }
  return table;
}

observe::Charge charge_of(const Outcome& outcome) {
  observe::Charge sum = outcome.summed_up ? outcome.summed_up->charge : observe::Charge();
  for (const Replicate* r : averaged_replicates(outcome))
    if (!r->read_before) sum.merge(r->charge);
  return sum;
}

Table fields(const Outcome& outcome) {
  Table table{
      {{"frame", "1", "carrier: rotates with the disc, or at rest; jar: rotates with the jar"},
       {"x", "m", "to the right in the plane, centre of the cell"},
       {"y", "m", "up in the plane, centre of the cell"},
       {"density", "kg/m2", "mass of balls per area of the plane, mean over time"},
       {"velocity_x", "m/s", "mean x velocity of that mass"},
       {"velocity_y", "m/s", "mean y velocity of that mass"},
       {"kinetic_energy", "J/m2", "translational energy of the balls, in that frame"}},
      {}};
  const observe::Charge charge = charge_of(outcome);
  if (!(charge.mass_total > 0)) return table;
  for (const auto& [name, field] :
       {std::pair("carrier", &charge.in_carrier), std::pair("jar", &charge.in_jar)}) {
    const double width = 2 * field->half() / PlaneField::cells;
    for (int j = 0; j < PlaneField::cells; ++j)
      for (int i = 0; i < PlaneField::cells; ++i) {
        if (field->density(i, j) == 0) continue;
        table.rows.push_back({table.columns[0].number_of(name), -field->half() + (i + 0.5) * width,
                              -field->half() + (j + 0.5) * width, field->density(i, j),
                              field->velocity_x(i, j), field->velocity_y(i, j),
                              field->kinetic_energy(i, j)});
      }
  }
  return table;
}

}  // namespace mahlwerk::results
