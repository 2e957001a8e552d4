// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/campaign/wear/worn_case.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::campaign {
namespace {

/// The outline of a bar, with a foot below the shell so that it stands there when the shell has
/// worn, but does not meet its neighbours.
geometry::Section outline(const geometry::LifterCylinder& drum) {
  const double radius = 0.5 * drum.diameter, slope = drum.side.cos / drum.side.sin;
  const auto half_width = [&](double foot) {
    return drum.top + (drum.lifter_height + foot) * slope;
  };
  double foot = drum.lifter_height;
  constexpr double room = 0.98;
  const double widest = room * std::numbers::pi / drum.lifters;
  for (int i = 0; i < 60 && math::atan2(half_width(foot), radius + foot) > widest; ++i) foot *= 0.8;
  const double high = radius - drum.lifter_height, low = radius + foot, half = half_width(foot);
  return {{high, -drum.top}, {low, -half}, {low, half}, {high, drum.top}};
}

std::string free_name(const cases::Case& c) {
  std::string name = "lifters";
  while (std::ranges::any_of(c.machine_parts,
                             [&](const cases::MachinePart& part) { return part.name == name; }))
    name += "-of-jar";
  return name;
}

/// Rules of the jar hold for its lifters, too.
void repeat_rules(cases::Case& c, const std::string& part) {
  std::vector<cases::PairRule> rules;
  for (const cases::PairRule& rule : c.contact.pairs) {
    rules.push_back(rule);
    cases::PairRule again = rule;
    for (std::string& name : again.between)
      if (name == "jar") name = "parts." + part;
    if (again != rule) rules.push_back(again);
  }
  c.contact.pairs = rules;
}

}  // namespace

cases::Case with_lifters_as_part(cases::Case c, geometry::Section& section) {
  const auto* drum = geometry::as<geometry::LifterCylinder>(*c.jar.shape);
  const auto* slice = geometry::as<geometry::PeriodicLifterCylinder>(*c.jar.shape);
  if (drum == nullptr && slice == nullptr) return c;
  const geometry::LifterCylinder bars = drum != nullptr ? *drum : slice->drum;
  constexpr double longer = 1.2;  // than the jar, so that the bars have no ends in it
  section = outline(bars);
  cases::MachinePart part;
  part.name = free_name(c);
  part.file = "lifters.csv", part.unit = "m";
  part.length = longer * bars.height;
  part.rows = static_cast<std::int64_t>(bars.lifters);
  part.material = c.jar.material;
  part.elastic = c.jar.elastic, part.substance = c.jar.substance, part.density = c.jar.density;
  part.body.solid = geometry::MeshSolid(
      geometry::weld(geometry::prism(section, part.length, static_cast<int>(part.rows))),
      *geometry::MeshSolid::fields()[0].standard);
  if (slice != nullptr)
    c.jar.shape = geometry::PeriodicCylinder{bars.diameter, bars.height};
  else
    c.jar.shape = geometry::Cylinder{bars.diameter, bars.height};
  repeat_rules(c, part.name);
  c.machine_parts.push_back(std::move(part));
  return c;
}

}  // namespace mahlwerk::campaign
