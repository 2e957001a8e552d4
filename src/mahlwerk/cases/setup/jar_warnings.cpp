// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Warnings about the jar and its contents.
#include <fmt/format.h>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/geometry/mesh.hpp"

namespace mahlwerk::cases {
namespace {

std::string tight_hollows(const Case& c) {
  const auto* mesh = geometry::as<geometry::Mesh>(*c.jar.shape);
  if (mesh == nullptr) return "";
  const double bend = mesh->min_concave_radius(), ball = 0.5 * largest_ball(c.balls);
  if (!(ball > bend * (1 + 1e-3))) return "";
  return fmt::format(
      "A ball of radius {} is larger than the smallest concave radius of a smooth face of the jar, "
      "{}. The ball may touch such a face at two points, and only the nearest point counts. A "
      "smaller jar.crease_angle divides the face.",
      show_rounded(ball, "m"), show_rounded(bend, "m"));
}

/// Warns if the bulk volume of loose powder exceeds the free volume of the jar. A powder of unknown
/// density may be as heavy as the heaviest solid.
std::string heaped_powder(const Case& c) {
  constexpr double packing = 0.6;   // of loose powder, about that of spheres
  constexpr double osmium = 22590;  // [kg/m3] CRC Handbook
  if (!c.powder || c.powder->grain_size) return "";
  const double bulk = c.powder->mass / c.powder->density.value_or(osmium) / packing;
  const double room = jar_volume(c.jar) - balls_volume(sets_at_start(c));
  if (!(bulk > room)) return "";
  const std::string least = c.powder->density
                                ? ""
                                : fmt::format(" at least, as no solid is denser than {}",
                                              show_rounded(osmium, "kg/m3", 3));
  return fmt::format(
      "The powder, packed to {} % of solid, takes {}{}, more than the balls leave free in the jar "
      "({}): no room is left for milling. Check the mass of the powder and its unit.",
      show_rounded(100 * packing, ""), show_rounded(bulk, "m3"), least, show_rounded(room, "m3"));
}

}  // namespace

Notices jar_warnings(const Case& c) {
  Notices all;
  for (Notice& one : std::array{warning("tight-hollow", tight_hollows(c)),
                                warning("too-much-powder", heaped_powder(c))})
    if (!one.text.empty()) all.push_back(std::move(one));
  return all;
}

}  // namespace mahlwerk::cases
