// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <numbers>

#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/part_files.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/cases/sections/vector_key.hpp"
#include "mahlwerk/geometry/solids.hpp"
#include "mahlwerk/scene/chamber.hpp"

// [[parts]]: bodies of the mill in the jar.
namespace mahlwerk::cases {
namespace {

using kinematics::PartMotion;
using Kind = PartMotion::Kind;

constexpr std::string_view name_rule = "letters, digits, - and _";

bool is_name(const std::string& name) {
  return !name.empty() && std::ranges::all_of(name, [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '-' || c == '_';
  });
}

void describe_name(KeyVisitor& v, MachinePart& part) {
  v.text({"name", "by which results and [[contact.pairs]] call the part, as parts.NAME", true},
         part.name);
  SectionReader* in = v.reader();
  if (in == nullptr || is_name(part.name)) return;
  if (const Node* at = in->find("name"))
    in->fault(*at, fmt::format("name = \"{}\" is not a name", part.name),
              fmt::format("use {}", name_rule), "wrong-type");
  else
    in->missing("name", "the name of the part", "write for instance name = \"stirrer\"");
}

void describe_solid(KeyVisitor& v, MachinePart& part) {
  const auto numbers = [&]<class S>(S& solid) {
    if (std::is_same_v<S, geometry::MeshSolid> && v.reader() != nullptr)
      return read_part_mesh(*v.reader(), part);
    if (std::is_same_v<S, geometry::MeshSolid>) describe_part_mesh(v, part);
    v.fields(solid, S::fields());
  };
  std::visit(numbers, *part.body.solid);
}

/// The rotation that lays a part's own z axis along `axis` and turns it by `angle` about that.
Rotation placed_along(const Vec3& axis, double angle) {
  return scene::mounted_along(axis) * rotation_about({0, 0, 1}, angle);
}

/// The place of a part in its frame. Writers give axis and angle again.
void describe_place(KeyVisitor& v, scene::MachinePart& body) {
  constexpr std::string_view standard = "along the axis of the jar";
  describe(v,
           {{"position", "m", any_number,
             "of the part's middle in its frame; of a plane, a "
             "point of it"},
            {},
            "the middle of the jar"},
           body.position);
  Vec3 axis = body.axes.ez;
  describe(v,
           {{"axis", "", any_number, "direction of the part's own axis in its frame"},
            {0, 0, 1},
            standard,
            true},
           axis);
  const Vec3 x = scene::mounted_along(axis).apply_inverse(body.axes.ex);
  double angle = math::atan2(x.y, x.x);
  v.number({"angle", "rad", any_number, "by which the part is turned about its own axis", 0.0,
            "its own x as near as possible to that of its frame"},
           angle);
  if (v.reader() != nullptr) body.axes = placed_along(axis, angle);
  v.word({"frame",
          {"jar", "laboratory"},
          "jar",
          "a part that is fixed to the jar",
          "frame of position, axes and motion",
          {"the jar's own axes: the part moves with the jar",
           "the laboratory, from the mill's origin: the jar moves past the part"}},
         body.in_laboratory);
}

void describe_shaking(KeyVisitor& v, PartMotion& m) {
  v.number(NumberSpec("frequency", "Hz", positive, "oscillations per second")
               .with({.start = "10 Hz", .usual = kinematics::frequencies}),
           m.frequency);
  v.number({"phase", "rad", any_number, "of the sine at time 0", 0.0,
            "the middle of the stroke at time 0"},
           m.phase);
}

void describe_axis_of_motion(KeyVisitor& v, const scene::MachinePart& body, PartMotion& m,
                             bool with_pivot) {
  describe(v,
           {{"motion_axis", "", any_number,
             with_pivot ? "axis about which the part turns" : "direction in which it moves"},
            body.axes.ez,
            "the part's own axis",
            true},
           m.axis);
  if (with_pivot)
    describe(v,
             {{"pivot", "m", any_number, "a point of the axis about which it turns"},
              body.position,
              "the position of the part"},
             m.pivot);
}

/// Whether the part shares the motion of another, and so has none of its own.
bool describe_shared_motion(KeyVisitor& v, MachinePart& part) {
  v.text({"moves_with",
          "name of the part with which this one moves, about the same axis and pivot; instead of a "
          "motion of its own"},
         part.moves_with);
  if (part.moves_with.empty() || v.visits_all()) return false;
  v.refuse({"motion", "speed", "motion_axis", "pivot", "amplitude", "frequency", "phase", "swing",
            "motion_file"},
           "for a part that moves with another", "remove it, or remove `moves_with`");
  return true;
}

void describe_motion(KeyVisitor& v, MachinePart& part) {
  if (describe_shared_motion(v, part)) return;
  PartMotion& m = part.body.motion;
  if (!v.word({"motion",
               {"fixed", "turning", "oscillating", "swinging", "tabulated"},
               "fixed",
               "a part that does not move in its frame",
               "motion of the part in its frame",
               {"at rest", "about an axis, at constant speed", "to and fro along a line",
                "to and fro about an axis", "measured, from a table"}},
              m.kind))
    return v.ignore_unknown_keys();
  const bool pivots =
      m.kind == Kind::turning || m.kind == Kind::swinging || m.kind == Kind::tabulated;
  if (v.reader() != nullptr && pivots) m.pivot = part.body.position;
  switch (m.kind) {
    case Kind::turning:
      v.number(NumberSpec("speed", "rad/s", any_number, "of the part about its axis, in its frame")
                   .plausible_within("", "10000 rpm")
                   .with({.label = "speed of the part", .start = "300 rpm"}),
               m.speed);
      return describe_axis_of_motion(v, part.body, m, true);
    case Kind::oscillating:
      v.number(
          NumberSpec("amplitude", "m", not_negative, "half the stroke").with({.start = "5 mm"}),
          m.amplitude);
      describe_shaking(v, m);
      return describe_axis_of_motion(v, part.body, m, false);
    case Kind::swinging:
      v.number(NumberSpec("swing", "rad", {.least = 0, .most = std::numbers::pi},
                          "largest angle to either side")
                   .with({.start = "30 deg"}),
               m.swing);
      describe_shaking(v, m);
      return describe_axis_of_motion(v, part.body, m, true);
    case Kind::tabulated:
      return describe_part_motion_file(v, part);
    case Kind::fixed:
      break;
  }
}

void describe_surface(KeyVisitor& v, MachinePart& part) {
  v.number({"opening", "m", not_negative,
            "balls below this diameter pass through, as through a "
            "grate",
            0.0, "no ball passes"},
           part.body.opening);
  constexpr TextSpec material{
      .key = "material",
      .about = "material of the part, by its name in the catalogue; gives the properties below",
      .category = "materials"};
  v.text(material, part.material);
  describe(v, part.elastic, part.material);
  describe(v, part.substance, part.material);
  v.number({"density", "kg/m3", positive, "density of the part, for the mass that wears off it",
            hardened_steel_density, "hardened steel (1.4034), handbook; uncalibrated"},
           part.density);
  v.optional_number(NumberSpec("friction", "", not_negative,
                               "Coulomb friction with all balls; left out: that of [contact]")
                        .plausible_within("0.001", "10"),
                    part.friction);
  v.optional_number(NumberSpec("restitution", "", restitution_range,
                               "restitution with all balls; left out: that of [contact]"),
                    part.restitution);
}

/// Gives the parts that move with another its motion.
void share_motions(std::vector<MachinePart>& parts, const Node& list, Findings& findings) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    MachinePart& part = parts[i];
    if (part.moves_with.empty()) continue;
    const auto other = std::ranges::find(parts, part.moves_with, &MachinePart::name);
    std::string remedy;
    if (other == parts.end())
      remedy = "give the name of another part";
    else if (!other->moves_with.empty())
      remedy = "name the part that has the motion";
    else if (other->body.in_laboratory != part.body.in_laboratory)
      remedy = "give both parts the same frame";
    if (remedy.empty())
      part.body.motion = other->body.motion;
    else
      findings.faults.push_back(
          {list.items[i].find("moves_with")->where,
           fmt::format("the part {} cannot move with \"{}\"", part.name, part.moves_with),
           std::move(remedy), "bad-part"});
  }
}

}  // namespace

void describe(KeyVisitor& v, MachinePart& part) {
  describe_name(v, part);
  if (!v.model({.key = "kind", .words = {}, .standard = "", .about = "shape of the part"},
               *part.body.solid))
    return v.ignore_unknown_keys();
  describe_solid(v, part);
  describe_place(v, part.body);
  describe_motion(v, part);
  describe_surface(v, part);
}

std::vector<MachinePart> read_machine_parts(const Node* list, Findings& findings) {
  std::vector<MachinePart> parts;
  if (list == nullptr) return parts;
  bool tables = list->kind == Node::Kind::list && !list->items.empty();
  for (const Node& item : list->items) tables = tables && item.kind == Node::Kind::table;
  if (!tables) {
    findings.faults.push_back({list->where, "`parts` must be a list of parts",
                               "write [[parts]] with name and kind", "wrong-type"});
    return parts;
  }
  for (const Node& item : list->items) {
    SectionReader in(&item, fmt::format("parts.{}", parts.size() + 1), findings);
    describe(in, parts.emplace_back());
    in.report_unknown_keys();
    const std::string& name = parts.back().name;
    const auto same = [&](const MachinePart& p) { return p.name == name; };
    if (std::ranges::count_if(parts, same) > 1 && in.gives("name"))
      in.fault(*in.find("name"), fmt::format("two parts have the name \"{}\"", name),
               "give each part a name of its own", "wrong-type");
  }
  share_motions(parts, *list, findings);
  return parts;
}

}  // namespace mahlwerk::cases
