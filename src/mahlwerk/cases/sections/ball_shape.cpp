// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The shape of the balls of a set that are no spheres.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

using ShapeKind = BallShape::Kind;
constexpr std::int64_t most_spheres = 2000;

void describe_shape_word(KeyVisitor& v, BallShape& body) {
  const SectionReader* in = v.reader();
  if (in == nullptr ? body.is_sphere() && !v.visits_all() : !v.gives("shape")) return;
  v.word({"shape",
          body_words(),
          "sphere",
          "balls are spheres",
          "shape of the balls",
          {"balls", "cylinders with flat ends, as rings of spheres",
           "cylinders with round ends, as rows of spheres",
           "cubes with round edges, as grids of spheres",
           "ellipsoids of revolution, as rows of spheres", "the spheres of `members`"}},
         body.kind);
}

bool has_convex_form(ShapeKind kind) {
  return kind == ShapeKind::cylpebs || kind == ShapeKind::rod || kind == ShapeKind::cube;
}

void describe_surface(KeyVisitor& v, BallShape& body) {
  v.word({"surface",
          surface_words(),
          "spheres",
          "works with every jar and part",
          "what of a body touches",
          {"spheres that stand for the shape", "the shape itself, with rounded edges"}},
         body.surface);
}

constexpr double usual_rounding = 0.1;  // of the diameter of convex cylpebs

/// Faults for given keys that the shape does not have.
void refuse_keys_of_others(KeyVisitor& v, const BallShape& body) {
  const ShapeKind kind = body.kind;
  const auto useless = [&](std::initializer_list<std::string_view> keys) {
    v.refuse(keys, fmt::format("with shape = \"{}\"", to_word(kind, body_words())),
             "remove it, or choose another shape");
  };
  if (kind == ShapeKind::sphere)
    return useless({"length", "edge", "rounding", "spheres", "members", "surface"});
  useless({"distribution", "spread", "smallest", "largest", "passing", "retained", "classes",
           "wall_thickness", "coating_thickness", "coating_density"});
  if (kind == ShapeKind::clump)
    return useless({"diameter", "length", "edge", "rounding", "spheres", "surface"});
  useless({"members"});
  if (kind == ShapeKind::cube) return useless({"diameter", "length"});
  useless({"edge"});
  if (kind == ShapeKind::ellipsoid) useless({"surface"});
  if (kind != ShapeKind::cylpebs) return useless({"rounding"});
  if (!body.is_convex())
    v.refuse({"rounding"}, "with shape = \"cylpebs\" made of spheres",
             "remove it, or write surface = \"convex\"");
}

constexpr NumberSpec member_centre("members", "m", any_number,
                                   "x, y, z and radius of each sphere of a clump");
constexpr NumberSpec member_radius =
    NumberSpec("members", "m", positive, "x, y, z and radius of each sphere of a clump")
        .plausible_within("", "0.5 m");

std::string members_text(const std::vector<geometry::MemberSphere>& members) {
  std::string rows;
  for (const geometry::MemberSphere& s : members) {
    const Vec3& c = s.centre;
    rows += fmt::format("{}[{}, {}, {}, {}]", rows.empty() ? "" : ", ", in_quotes(show(c.x, "m")),
                        in_quotes(show(c.y, "m")), in_quotes(show(c.z, "m")),
                        in_quotes(show(s.radius, "m")));
  }
  return "[" + rows + "]";
}

/// The spheres of a clump. False after a fault.
bool read_members(SectionReader& in, BallShape& body) {
  constexpr std::string_view example =
      "members = [[\"0 mm\", \"0 mm\", \"0 mm\", \"5 mm\"], [\"6 mm\", \"0 mm\", \"0 mm\", \"4 "
      "mm\"]]";
  const std::string remedy = fmt::format("write x, y, z and radius of each: {}", example);
  const Node* at = in.find("members");
  if (at == nullptr) {
    in.missing("members", "spheres of a clump", remedy);
    return false;
  }
  bool sound = at->kind == Node::Kind::list && !at->items.empty();
  if (!sound) in.fault(*at, "`members` must be a list of spheres", remedy, "wrong-type");
  for (const Node& row : at->items) {
    if (!sound) return false;
    sound = row.kind == Node::Kind::list && row.items.size() == 4;
    if (!sound) {
      in.fault(row, fmt::format("member {} must have four numbers", body.members.size() + 1),
               remedy, "wrong-type");
      return false;
    }
    const auto centre = [&](std::size_t k) { return in.quantity(row.items[k], member_centre); };
    const double x = centre(0), y = centre(1), z = centre(2);
    const double radius = in.quantity(row.items[3], member_radius);
    body.members.push_back({{x, y, z}, radius});
    sound = !std::isnan(x + y + z + radius);
  }
  if (!sound) return false;
  body.spheres = std::ssize(body.members);
  if (const std::string flaw = flaw_of_members(body.members); !flaw.empty()) {
    in.fault(*at, flaw, "move or change the members so that they overlap and make one body",
             "out-of-range");
    return false;
  }
  in.record_origin("members", members_text(body.members), at);
  return true;
}

/// A clump, whose spheres are given. A reader sets the diameter.
void describe_clump(KeyVisitor& v, BallShape& body, double& diameter) {
  if (SectionReader* in = v.reader()) {
    diameter = read_members(*in, body) ? 2 * body.solid().equivalent_radius() : invalid_value;
    return;
  }
  v.custom(
      {.key = "members",
       .about = "spheres of a clump, each with x, y, z and radius, in axes of its own; mass and "
                "inertia are those of their union",
       .sound = flaw_of_members(body.members).empty(),
       .required = true},
      [&] { return members_text(body.members); });
}

void describe_shape_numbers(KeyVisitor& v, BallShape& body) {
  if (body.kind == ShapeKind::cube) {
    v.number(NumberSpec("edge", "m", positive, "edge of a cube").plausible_within("", "0.5 m"),
             body.edge);
    v.number({"rounding", "m", positive, "radius of the edges of a cube, below half of edge"},
             body.rounding);
    return;
  }
  v.number(NumberSpec("diameter", "m", positive, "diameter of a body across its axis")
               .plausible_within("", "0.5 m"),
           body.diameter);
  v.number(NumberSpec("length", "m", positive, "length of a body along its axis")
               .plausible_within("", "2 m"),
           body.length);
  if (body.kind == ShapeKind::cylpebs && body.is_convex())
    v.number(NumberSpec("rounding", "m", positive, "radius of the rims of a cylinder")
                 .with_default(usual_rounding * std::min(body.diameter, body.length),
                               "a tenth of the diameter, or of the length if that is less"),
             body.rounding);
}

/// A fault unless the edges are rounded less than half of `width` [m].
bool rounds_edges(SectionReader& in, double rounding, double width, const char* of,
                  const char* rounder) {
  if (std::isnan(rounding) || std::isnan(width)) return false;
  if (rounding < width / 2) return true;
  in.fault(in.find("rounding") != nullptr ? *in.find("rounding") : *in.find("shape"),
           fmt::format("rounding ({}) is not below half of {} ({})", show_rounded(rounding, "m"),
                       of, show_rounded(width, "m")),
           fmt::format("give a smaller rounding; {}", rounder), "out-of-range");
  return false;
}

/// A fault if spheres would be too many for the longer of two lengths by the shorter one.
bool is_compact(SectionReader& in, const BallShape& body) {
  constexpr double most = 200;
  const bool cube = body.kind == ShapeKind::cube;
  const double a = cube ? body.edge : body.diameter, b = cube ? body.rounding : body.length;
  if (cube && body.is_convex()) return true;
  if (!(std::max(a, b) > most * std::min(a, b))) return true;
  in.fault(
      *in.find("shape"),
      fmt::format("{} ({}) and {} ({}) differ by more than {:g} times", cube ? "edge" : "diameter",
                  show_rounded(a, "m"), cube ? "rounding" : "length", show_rounded(b, "m"), most),
      "give lengths that differ less", "out-of-range");
  return false;
}

/// The numbers must make the shape. False after a fault.
bool makes_a_solid(SectionReader& in, const BallShape& body) {
  if (!is_compact(in, body)) return false;
  if (body.kind == ShapeKind::cube)
    return rounds_edges(in, body.rounding, body.edge, "edge", "shape = \"sphere\" is a ball");
  if (std::isnan(body.diameter + body.length)) return false;
  const bool flat = body.kind == ShapeKind::cylpebs;
  if (flat && body.is_convex())
    return rounds_edges(in, body.rounding, std::min(body.diameter, body.length),
                        "the smaller of diameter and length",
                        "shape = \"rod\" has hemispherical ends");
  if (flat ? body.length >= body.diameter / 2 : body.length > body.diameter) return true;
  in.fault(*in.find("length"),
           fmt::format("length ({}) is not {} diameter ({})", show_rounded(body.length, "m"),
                       flat ? "at least half of" : "above", show_rounded(body.diameter, "m")),
           flat ? "give a longer cylinder, or surface = \"convex\" for a disc"
                : "give a greater length; shape = \"sphere\" is a ball",
           "out-of-range");
  return false;
}

/// The number of spheres, the usual one if it is not given. False after a fault.
bool read_spheres(SectionReader& in, BallShape& body) {
  if (!in.gives("spheres")) {
    body.spheres = body.usual_spheres();
    in.record_default("spheres", std::to_string(body.spheres),
                      "neighbours are a radius of theirs apart");
  }
  if (in.gives("spheres") && body.spheres < 2) return false;  // a fault already
  const std::int64_t fewest = body.fewest_spheres();
  if (body.spheres >= fewest && body.spheres <= most_spheres) return true;
  const Node* at = in.find("spheres") != nullptr ? in.find("spheres") : in.find("shape");
  if (fewest > most_spheres)
    in.fault(
        *at,
        fmt::format("this shape needs at least {} spheres, more than {}", fewest, most_spheres),
        "give lengths that differ less, or surface = \"convex\"", "out-of-range");
  else
    in.fault(*at, fmt::format("{} spheres do not make this shape", body.spheres),
             fmt::format("give {} to {}", fewest, most_spheres), "out-of-range");
  return false;
}

}  // namespace

bool describe_body(KeyVisitor& v, BallShape& body, double& diameter) {
  describe_shape_word(v, body);
  if (has_convex_form(body.kind)) describe_surface(v, body);
  refuse_keys_of_others(v, body);
  if (body.is_sphere()) return false;
  if (body.kind == ShapeKind::clump) {
    describe_clump(v, body, diameter);
    return true;
  }
  describe_shape_numbers(v, body);
  SectionReader* in = v.reader();
  if (body.is_convex())
    v.refuse({"spheres"}, "with surface = \"convex\"", "remove it");
  else if (in == nullptr || v.gives("spheres"))
    v.integer({.key = "spheres",
               .least = 2,
               .most = most_spheres,
               .about = "largest number of spheres that make a body",
               .default_text = "as many as lie a radius of theirs apart"},
              body.spheres);
  if (in == nullptr) return true;
  if (body.is_convex()) body.spheres = 1;  // that holds it, for work and memory
  const bool sound = makes_a_solid(*in, body) && (body.is_convex() || read_spheres(*in, body));
  diameter = sound ? 2 * body.solid().equivalent_radius() : invalid_value;
  return true;
}

}  // namespace mahlwerk::cases
