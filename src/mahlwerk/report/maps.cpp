// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/maps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "mahlwerk/kinematics/carrier.hpp"
#include "mahlwerk/kinematics/planetary.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/results/quantities/part_map.hpp"
#include "mahlwerk/results/quantities/spectra.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::report {
namespace {

using observe::PlaneField;
using observe::WallGrid;

constexpr double millimetre = 1e-3;

/// The value that the highest one in `share` of the values exceed, so that the rest stay
/// distinguishable.
double nearly_highest(std::vector<double> values, std::size_t one_in) {
  std::ranges::sort(values);
  return values[values.size() - 1 - values.size() / one_in];
}

/// `count` + 1 edges that divide `from` to `to` equally.
std::vector<double> edges(double from, double to, int count) {
  std::vector<double> list;
  for (int i = 0; i <= count; ++i) list.push_back(from + (to - from) * i / count);
  return list;
}

/// A part of the wall: its cells follow each other, by angle and then by height or radius.
MapPanel wall_part(const results::WallRates& rates, int first, int count) {
  const bool side = WallGrid::part(first) == WallGrid::Part::side;
  const int around = side ? WallGrid::around : WallGrid::sectors;
  MapPanel panel;
  panel.title = side                                           ? "side, unrolled"
                : WallGrid::part(first) == WallGrid::Part::top ? "upper end"
                                                               : "lower end";
  panel.x = {.label = "angle about the axis (°)", .edges = edges(0, 360, around)};
  panel.y = {.label = side ? "height (mm)" : "radius (mm)"};
  for (int cell = first; cell < first + count; cell += around)
    panel.y.edges.push_back(rates.grid.bounds(cell).across[0] / millimetre);
  panel.y.edges.push_back(rates.grid.bounds(first + count - 1).across[1] / millimetre);
  for (int cell = first; cell < first + count; ++cell) {
    const auto i = static_cast<std::size_t>(cell);
    // Cells without area have no density.
    panel.values.push_back(rates.area[i] > 0 ? rates.lost[i] / rates.area[i] : NAN);
  }
  panel.polar = !side;
  panel.width = side ? 520 : 180;
  panel.shape = !side ? 1
                      : std::clamp((rates.grid.top - rates.grid.bottom) /
                                       (2 * std::numbers::pi * rates.grid.radius),
                                   0.13, 0.64);
  return panel;
}

/// What of a part faces one way.
MapPanel part_view(const results::PartRates& rates, observe::PartGrid::Side side) {
  static constexpr std::array axis_names{"x (mm)", "y (mm)", "z (mm)"};
  constexpr double widest = 300, margin = 60;  // [px]
  const auto [columns, rows] = rates.grid.counts(side);
  const auto [along, across] = observe::PartGrid::axes(side);
  const int first = rates.grid.first(side);
  const auto low = rates.grid.bounds(first), high = rates.grid.bounds(first + columns * rows - 1);
  MapPanel panel;
  panel.title = fmt::format("{}{}", side % 2 == 0 ? "−" : "+", "xyz"[side / 2]);
  panel.x = {.label = axis_names[static_cast<std::size_t>(along)],
             .edges = edges(low.along[0] / millimetre, high.along[1] / millimetre, columns)};
  panel.y = {.label = axis_names[static_cast<std::size_t>(across)],
             .edges = edges(low.across[0] / millimetre, high.across[1] / millimetre, rows)};
  for (int cell = first; cell < first + columns * rows; ++cell) {
    const auto i = static_cast<std::size_t>(cell);
    panel.values.push_back(rates.area[i] > 0 ? rates.lost[i] / rates.area[i] : NAN);
  }
  const auto [x, y] = rates.grid.counts(observe::PartGrid::top);
  const int most = std::max({x, y, rates.grid.counts(observe::PartGrid::left)[1]});
  panel.width = margin + widest * columns / most;
  panel.shape = static_cast<double>(rows) / columns;
  return panel;
}

bool has_value(const MapPanel& panel) {
  return std::ranges::any_of(panel.values, [](double v) { return std::isfinite(v); });
}

/// One field: mass density as colour, velocity as arrows.
MapPanel field(const PlaneField& f, double densest, double fastest, double ring) {
  constexpr int apart = 3;
  const std::vector<double> sides =
      edges(-f.half() / millimetre, f.half() / millimetre, PlaneField::cells);
  MapPanel panel{.title = "",
                 .x = {.label = "x (mm)", .edges = sides},
                 .y = {.label = "y (mm)", .edges = sides},
                 .ring = ring / millimetre,
                 .width = 350,
                 .shape = 1};
  for (int j = 0; j < PlaneField::cells; ++j)
    for (int i = 0; i < PlaneField::cells; ++i) {
      const double d = f.density(i, j);
      panel.values.push_back(d > 0 ? d : NAN);
      if (i % apart != apart / 2 || j % apart != apart / 2 || d < 0.02 * densest) continue;
      for (const double v : {static_cast<double>(i), static_cast<double>(j),
                             f.velocity_x(i, j) / fastest, f.velocity_y(i, j) / fastest})
        panel.arrows.push_back(v);
    }
  return panel;
}

}  // namespace

std::optional<ColourMap> wall_power_map(const results::Outcome& outcome) {
  const results::WallRates rates = results::wall_rates(outcome);
  ColourMap map{.title = "Impacts on the wall", .quantity = "power lost per area", .unit = "W/m²"};
  std::vector<double> all;
  for (std::size_t i = 0; i < rates.area.size(); ++i)
    all.push_back(rates.area[i] > 0 ? rates.lost[i] / rates.area[i] : 0);
  map.most = nearly_highest(all, 200);
  if (!(map.most > 0)) return std::nullopt;
  constexpr int ends = WallGrid::side_cells + WallGrid::disc_cells;
  for (MapPanel& panel : std::vector{wall_part(rates, 0, WallGrid::side_cells),
                                     wall_part(rates, ends, WallGrid::disc_cells),
                                     wall_part(rates, WallGrid::side_cells, WallGrid::disc_cells)})
    if (has_value(panel)) map.panels.push_back(panel);
  return map;
}

std::vector<ColourMap> part_power_maps(const results::Outcome& outcome, std::size_t most) {
  const std::vector<results::PartRates> parts = results::part_rates(outcome);
  std::vector<std::pair<double, std::size_t>> order;  // by power, the highest first
  for (std::size_t k = 0; k < parts.size(); ++k)
    order.emplace_back(-std::accumulate(parts[k].lost.begin(), parts[k].lost.end(), 0.0), k);
  std::ranges::sort(order);
  std::vector<ColourMap> maps;
  for (const auto& [power, k] : order) {
    if (!(power < 0) || maps.size() == most) break;
    const results::PartRates& part = parts[k];
    std::vector<double> all;
    for (std::size_t i = 0; i < part.lost.size(); ++i)
      if (part.area[i] > 0) all.push_back(part.lost[i] / part.area[i]);
    ColourMap map{.title = fmt::format("Impacts on {}", outcome.mill_case.machine_parts[k].name),
                  .quantity = "power lost per area",
                  .unit = "W/m²",
                  // Edges have many hits and little area.
                  .most = nearly_highest(all, 20),
                  .note = "a twentieth of the cells is above the scale"};
    for (int side = 0; side < observe::PartGrid::sides; ++side)
      if (MapPanel view = part_view(part, static_cast<observe::PartGrid::Side>(side));
          std::ranges::any_of(view.values, [](double v) { return v > 0; }))
        map.panels.push_back(std::move(view));
    if (map.most > 0 && !map.panels.empty()) maps.push_back(std::move(map));
  }
  return maps;
}

std::optional<ColourMap> charge_map(const results::Outcome& outcome) {
  const observe::Charge charge = results::charge_of(outcome);
  if (!(charge.mass_total > 0)) return std::nullopt;
  std::vector<double> found;
  double fastest = 0;
  for (const PlaneField* f : {&charge.in_carrier, &charge.in_jar})
    for (int j = 0; j < PlaneField::cells; ++j)
      for (int i = 0; i < PlaneField::cells; ++i)
        if (const double d = f->density(i, j); d > 0) {
          found.push_back(d);
          fastest = std::max(fastest, std::hypot(f->velocity_x(i, j), f->velocity_y(i, j)));
        }
  const kinematics::AnyMotion& motion = *outcome.mill_case.mill.motion;
  const Vec3 normal = kinematics::plane_normal(motion);
  const bool round = norm(cross(normal, outcome.mill_case.mill.jar_axis)) < 1e-9;
  const bool disc = kinematics::as<kinematics::Planetary>(motion) != nullptr;
  const double ring = round ? outcome.replicates.front().tally.wall_map.grid().radius : 0;
  ColourMap map{.title = "Mass and velocity of the charge",
                .quantity = "mass per area",
                .unit = "kg/m²",
                .most = nearly_highest(found, 100)};
  map.note = fmt::format("the longest arrow is {}", readable(fastest, NAN, "m/s").text());
  map.panels = {field(charge.in_carrier, map.most, fastest, ring),
                field(charge.in_jar, map.most, fastest, ring)};
  map.panels[0].title = disc ? "in the frame of the disc, outwards to the right"
                             : "in a non-rotating frame at the jar's centre";
  map.panels[1].title = "in the frame of the rotating jar";
  return map;
}

std::optional<ColourMap> joint_energy_map(const results::Outcome& outcome) {
  const results::Table table = results::normal_tangential(outcome);
  if (table.rows.empty()) return std::nullopt;
  const auto octave = [](double low) {
    return low > 0 ? static_cast<int>(std::lround(std::log2(low)))
                   : observe::JointHistogram::lowest_octave;
  };
  ColourMap map{.title = "Normal and tangential energy of collisions",
                .quantity = "collisions per second and bin",
                .unit = "1/s",
                .most = 0,
                .logarithmic = true};
  int highest = observe::JointHistogram::lowest_octave;
  for (const auto& row : table.rows) {
    map.most = std::max(map.most, row[4]);
    highest = std::max({highest, octave(row[0]), octave(row[2])});
  }
  map.least = 1e-4 * map.most;  // four decades of rates
  map.note = "above the dashed line: more tangential than normal energy";
  constexpr int shown = 24;  // octaves: seven decades
  const int first = highest - shown + 1;
  std::vector<double> octaves;
  for (int k = 0; k <= shown; ++k) octaves.push_back(std::ldexp(1.0, first + k));
  MapPanel panel{.title = "", .diagonal = true, .width = 430, .shape = 1};
  panel.x = {.label = "normal energy, $m u_{n}$^{2}/2",
             .edges = octaves,
             .logarithmic = true,
             .unit = "J"};
  panel.y = {.label = "tangential energy, $m u_{t}$^{2}/2",
             .edges = octaves,
             .logarithmic = true,
             .unit = "J"};
  panel.values.assign(std::size_t{shown} * shown, NAN);
  for (const auto& row : table.rows) {
    const int n = octave(row[0]) - first, t = octave(row[2]) - first;
    if (n >= 0 && t >= 0) panel.values[static_cast<std::size_t>(t * shown + n)] = row[4];
  }
  map.panels = {std::move(panel)};
  return map;
}

}  // namespace mahlwerk::report
