// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

std::string shape_key(const Case& c) {
  std::size_t set = 0;
  while (c.balls[set].body.is_sphere()) ++set;
  return fmt::format("balls.{}.shape", set + 1);
}

bool has_convex_bodies(const Case& c) {
  return std::ranges::any_of(c.balls, [](const BallSet& set) { return set.body.is_convex(); });
}

/// Whether no wall bulges into the jar, so that only corners and rims of convex bodies touch it.
bool has_convex_cavity(const Case& c) {
  return c.machine_parts.empty() &&
         (geometry::exact_touches(*c.jar.shape) ||
          std::holds_alternative<geometry::PeriodicCylinder>(*c.jar.shape));
}

/// What bodies that are no spheres do not go with, in the soft engine.
void refuse_with_bodies(const Case& c, std::vector<Fault>& found) {
  if (!has_bodies(c)) return;
  const auto refuse = [&](bool given, const std::string& key, const char* what,
                          const char* remedy) {
    if (given)
      found.push_back({location_of(c, key),
                       fmt::format("{} does not go with balls that are no spheres", what), remedy,
                       "not-with-bodies"});
  };
  refuse(c.liquid.has_value(), "liquid.kind", "a liquid", "remove [liquid], or shape");
  refuse(c.flow.has_value(), "flow.outlet", "a flow of balls", "remove [flow], or shape");
  refuse(c.contact.model.curved_walls, "contact.curved_walls", "curved_walls = true",
         "write curved_walls = false, or remove shape");
  refuse(c.run.device == DeviceName::gpu, "run.device", "device = \"gpu\"",
         "write device = \"cpu\", or remove shape");
  refuse(!c.run.start_from.file.empty(), "run.start_from",
         "start_from, whose files have no orientations,", "remove start_from, or shape");
  refuse(has_convex_bodies(c) && !has_convex_cavity(c), "jar.kind",
         "a jar with lifters, a stirrer or a mesh, or with parts,",
         "write surface = \"spheres\", or remove shape");
  refuse(c.observe.final_state, "observe.final_state",
         "final_state, whose files have no orientations,", "remove final_state, or shape");
}

/// Faults for the soft engine: its contacts have one damping for all speeds.
std::vector<Fault> soft_faults(const Case& c) {
  std::vector<Fault> found;
  refuse_with_bodies(c, found);
  const auto check = [&](const std::string& section, const contact::Restitution& e) {
    if (e.law() == contact::Restitution::Law::constant) return;
    found.push_back(
        {location_of(c, section + "restitution_law"),
         fmt::format("restitution_law = \"{}\": the soft engine takes one restitution for all "
                     "speeds",
                     restitution_laws()[static_cast<std::size_t>(e.law())]),
         "write restitution_law = \"constant\" and restitution = 0.8 or so, or engine = \"event\"",
         "constant-restitution"});
  };
  const contact::Restitution& all = c.contact.rule.restitution;
  check("contact.", all);
  for (std::size_t i = 0; i < c.contact.pairs.size(); ++i)
    if (const auto& own = c.contact.pairs[i].rule.restitution; own != all)
      check(fmt::format("contact.pairs.{}.", i + 1), own);
  return found;
}

/// Balls of the event engine fly freely between collisions, in which only films fit.
std::vector<Fault> liquid_faults(const Case& c) {
  if (!c.liquid || c.run.engine != EngineName::event) return {};  // "auto" chooses soft
  if (c.liquid->model.flooded)
    return {{location_of(c, "liquid.kind"),
             "kind = \"flooded\": the event engine computes free flight, in which no liquid drags",
             "write engine = \"soft\" or \"auto\", or kind = \"film\" without drag",
             "liquid-needs-soft"}};
  if (c.liquid->model.resists_rebound)
    return {{location_of(c, "liquid.rebound"),
             "rebound = \"resists\": the event engine takes a film that cavitates on rebound",
             "write rebound = \"cavitates\", or engine = \"soft\"", "liquid-needs-soft"}};
  return {};
}

std::vector<Fault> event_faults(const Case& c) {
  if (has_bodies(c))
    return {{location_of(c, shape_key(c)), "the event engine computes spheres only",
             "write engine = \"soft\" or \"auto\", or remove shape", "bodies-need-soft"}};
  if (auto found = liquid_faults(c); !found.empty()) return found;
  if (c.flow)
    return {{location_of(c, "run.engine"),
             "the event engine does not let balls leave the jar or enter it ([flow])",
             "write engine = \"soft\", or \"auto\"", "flow-needs-soft"}};
  if (c.bed_breakage)
    return {{location_of(c, "run.engine"), "in the event engine no grains break ([bed_breakage])",
             "write engine = \"soft\", or \"auto\"", "bed-breakage-needs-soft"}};
  if (const std::string wall = soft_only_wall(c); !wall.empty())
    return {{location_of(c, "run.engine"),
             fmt::format("the event engine does not take {}: it computes exact contact times from "
                         "a formula",
                         wall),
             "write engine = \"soft\", or \"auto\"", "jar-needs-soft"}};
  if (c.run.engine == EngineName::event && fits_exactly(c))
    return {
        {location_of(c, "run.engine"),
         "two balls fit exactly across the jar: hard spheres would be wedged there without any "
         "room to bounce",
         "write engine = \"soft\" or \"auto\", or change the diameter of a ball by a thousandth",
         "exact-fit"}};
  if (c.contact.lasting != SustainedContactModel::roll) return {};
  const std::int64_t count = balls_count(c.balls);
  if (count > 1)
    return {{location_of(c, "contact.lasting"),
             fmt::format("lasting = \"roll\" is for one ball, the case has {}", count),
             "write lasting = \"tc\"", "roll-one-ball"}};
  if (c.contact.model.rolling == contact::Rolling::viscous)
    return {{location_of(c, "contact.rolling"),
             "rolling = \"viscous\" is for the soft engine: in the event engine the resistance is "
             "the same at every speed",
             "write rolling = \"cdt\" with a rolling_friction without unit", "viscous-rolling"}};
  if (c.contact.model.rolling == contact::Rolling::own_spin)
    return {{location_of(c, "contact.rolling"),
             "rolling = \"own-spin\" is for the soft engine: the sustained contacts of the event "
             "engine resist the rolling relative to the wall",
             "write rolling = \"cdt\", or engine = \"soft\"", "own-spin-rolling"}};
  return {};
}

}  // namespace

bool liquid_needs_soft(const Case& c) {
  return c.liquid && (c.liquid->model.flooded || c.liquid->model.resists_rebound);
}

bool fits_exactly(const Case& c) {
  constexpr double tight = 1e-6;
  const double jar = 2 * geometry::inradius(*c.jar.shape);
  std::vector<double> diameters;  // of each size class; twice if it has two or more balls
  for (const BallSet& set : c.balls)
    for (const SizeClass& size : set.sizes())
      diameters.insert(diameters.end(), size.count > 1 ? 2 : 1, size.diameter);
  for (std::size_t i = 0; i < diameters.size(); ++i)
    for (std::size_t j = i + 1; j < diameters.size(); ++j)
      if (std::abs(diameters[i] + diameters[j] - jar) < tight * jar) return true;
  return false;
}

std::vector<Fault> engine_faults(const Case& c) {
  const bool exact = soft_only_wall(c).empty();  // else "auto" chooses soft
  const bool needs_soft =
      !exact || liquid_needs_soft(c) || c.flow || c.bed_breakage || has_bodies(c);
  const bool soft =
      in_time_steps(c.run.engine) || (needs_soft && c.run.engine == EngineName::automatic);
  return soft ? soft_faults(c) : event_faults(c);
}

}  // namespace mahlwerk::cases
