// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What LAMMPS cannot compute, and what it computes in another way.
#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/lammps/deck.hpp"
#include "mahlwerk/lammps/jar_terms.hpp"
#include "mahlwerk/lammps/notices.hpp"

namespace mahlwerk::lammps {
namespace {

bool faces_differ(const cases::Case& c) {
  const contact::PairTable table = cases::pair_table(c);
  for (int kind = 0; kind < table.kinds(); ++kind)
    for (int face = 1; face < table.faces(); ++face)
      if (!(table.wall(kind, face) == table.wall(kind, 0))) return true;
  return false;
}

bool resists_rolling(const cases::Case& c) {
  if (!contact::rule_of(c.contact.model.rolling).resists) return false;
  const contact::PairTable table = cases::pair_table(c);
  return std::ranges::any_of(table.all(), [](const auto& p) { return p.rolling_friction > 0; });
}

bool slides_with_strong_damping(const cases::Case& c) {
  constexpr double strong = 0.6;
  const contact::PairTable table = cases::pair_table(c);
  return std::ranges::any_of(
      table.all(), [](const auto& p) { return p.friction > 0 && p.restitution < strong; });
}

}  // namespace

std::vector<Fault> faults(const cases::Case& c) {
  std::vector<Fault> found;
  const auto refuse = [&](bool bad, const char* key, std::string what, std::string can) {
    if (bad)
      found.push_back({cases::location_of(c, key), "LAMMPS cannot compute " + std::move(what),
                       std::move(can) + ", or write engine = \"soft\"", "not-for-lammps"});
  };
  const geometry::AnyShape& jar = *c.jar.shape;
  const kinematics::AnyMotion& mill = *c.mill.motion;
  const std::string law(contact::name_of(*c.contact.model.law));
  refuse(!has_region(jar), "jar.kind", fmt::format("a jar of kind \"{}\"", geometry::name_of(jar)),
         "take one of the kinds " + known_regions());
  refuse(!has_body_force(mill), "mill.kind",
         fmt::format("a mill of kind \"{}\"", kinematics::name_of(mill)),
         "take one of the kinds " + known_motions());
  refuse(geometry::as<geometry::Capsule>(jar) && kinematics::bounds(mill).spin > 0, "jar.kind",
         "a jar of kind \"capsule\" that turns: its regions are a union, which cannot turn",
         "take a cylinder");
  refuse(law != "hertz-mindlin" && law != "linear-spring", "contact.law",
         fmt::format("law = \"{}\"", law), "write law = \"hertz-mindlin\" or \"linear-spring\"");
  refuse(std::ranges::any_of(c.balls, [](const auto& set) { return set.layers().layered(); }),
         "balls", "hollow or coated balls: its spheres are homogeneous",
         "leave out wall_thickness and coating_thickness");
  refuse(cases::has_bodies(c), "balls", "balls that are no spheres here",
         "write shape = \"sphere\"");
  refuse(c.contact.model.rolling == contact::Rolling::viscous, "contact.rolling",
         "rolling = \"viscous\"", "write rolling = \"cdt\" or \"none\"");
  refuse(c.contact.model.partial_slip, "contact.partial_slip", "partial_slip = true",
         "write partial_slip = false");
  refuse(c.contact.model.twisting != contact::Twisting::none && law != "hertz-mindlin",
         "contact.twisting", "twisting friction with law = \"" + law + "\"",
         "write law = \"hertz-mindlin\" or twisting = \"none\"");
  refuse(c.drive.has_value(), "drive.inertia", "a mill that a motor turns", "remove [drive]");
  refuse(!c.machine_parts.empty(), "parts.1.kind", "parts in the jar", "remove [[parts]]");
  refuse(c.liquid.has_value(), "liquid", "a liquid: its films act on bodies that do not touch",
         "remove [liquid]");
  refuse(c.flow.has_value(), "flow.outlet", "balls that leave the jar and enter it",
         "remove [flow]");
  refuse(c.bed_breakage.has_value(), "bed_breakage", "grains that break while they move",
         "remove [bed_breakage]");
  refuse(c.run.until.has_value(), "run.time", "time = \"until ...\": its runs have a given length",
         "give a time");
  refuse(c.run.start == cases::StartLayout::ramp, "run.start",
         "start = \"ramp\": its mills run at their speed from the start", "remove start");
  refuse(!c.mill.speed_over_time.empty(), "mill.speed_over_time",
         "a speed over time: its mills run at one speed", "remove speed_over_time");
  refuse(faces_differ(c), "contact", "faces of the jar with different contact values",
         "give the same values to all faces");
  return found;
}

Notices model_notices(const cases::Case& c) {
  Notices list;
  if (resists_rolling(c))
    list.push_back(
        note("lammps-rolling",
             "Rolling resistance in LAMMPS is a spring with a slider of constant torque, rolling = "
             "\"epsd\" without its damper; its spring is that of a contact at 1 m/s."));
  if (slides_with_strong_damping(c))
    list.push_back(
        note("lammps-sliding",
             "With a restitution below 0.6, sliding friction is weaker in LAMMPS than in "
             "the soft engine: a ball gets 94 % of the spin of Coulomb's law at 0.5, 86 % "
             "at 0.35."));
  if (!c.contact.model.curved_walls)
    list.push_back(note("lammps-walls",
                        "Walls of LAMMPS include the wall's curvature in the radius of contact, as "
                        "curved_walls = true does in the soft engine."));
  return list;
}

Notices notices(const cases::Case& c) {
  Notices list{note(
      "lammps",
      "Computed by LAMMPS. How its numbers were got: drawn power from the torque of the wall and "
      "the body force; dissipated power from the balance of energy (lmp.7); every contact of "
      "two balls is counted, and its speeds are those at first touch in a frame, or of a like "
      "contact that a frame shows (lmp.10); collisions with the jar from frequent looks for "
      "new contacts (lmp.9, lmp.11). In tables, the losses of a collision are those "
      "of an undisturbed one. No residual of energy is given: the balance closes by its "
      "definition.")};
  append(list, model_notices(c));
  return list;
}

Notices restart_notices(int restarts) {
  if (restarts == 0) return {};
  return {note(
      "lammps-restarted",
      fmt::format(
          "LAMMPS went on {} from a restart file. It sums forces in another order from there on, "
          "so "
          "that the balls part by chaos from those of a run that nothing interrupted. The numbers "
          "differ as those of two starts do: in a drum of 40 balls by 2.4 % in power and 9 % in "
          "hits above the threshold (root mean square of 16 runs), without a bias in power of more "
          "than 2 %.",
          restarts == 1 ? std::string("once") : fmt::format("{} times", restarts)))};
}

}  // namespace mahlwerk::lammps
