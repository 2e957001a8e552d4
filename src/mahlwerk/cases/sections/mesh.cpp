// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/file/stl.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

using geometry::Flaw;
using geometry::Mesh;
using geometry::Surface;

constexpr double widest = 10, narrowest = 1e-3;  // [m] plausible widths of a jar

std::string position_text(const Vec3& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x, 1e3 * p.y, 1e3 * p.z);
}

std::string edges(std::size_t count) {
  return count == 1 ? "1 edge" : fmt::format("{} edges", count);
}

/// The fault for a flaw of the mesh, with its remedy.
Fault mesh_fault(const Flaw& flaw, const std::string& file) {
  const auto fault = [&](std::string what, const char* remedy, const char* code) {
    return Fault{"", fmt::format("{}: {}", file, what), remedy, code};
  };
  switch (flaw.kind) {
    case Flaw::Kind::open:
      return fault(fmt::format("the surface is open: {} belong to one triangle only, one at {}",
                               edges(flaw.count), position_text(flaw.where)),
                   "close the holes: draw the inner volume as a solid and export that",
                   "open-mesh");
    case Flaw::Kind::non_manifold:
      return fault(fmt::format("at {} more than two triangles meet, at {} for instance",
                               edges(flaw.count), position_text(flaw.where)),
                   "join the parts to one solid before exporting, without inner walls",
                   "crowded-mesh");
    case Flaw::Kind::misoriented:
      return fault(
          fmt::format("at {} neighbours disagree which side is outside, at {} for instance",
                      edges(flaw.count), position_text(flaw.where)),
          "let the CAD program orient all normals outwards", "twisted-mesh");
    case Flaw::Kind::several_shells:
      return fault(fmt::format("the surface has {} parts that are not connected, the second "
                               "at {}",
                               flaw.count, position_text(flaw.where)),
                   "export the inner volume alone, as one solid: without the jar's outside and "
                   "loose parts",
                   "several-meshes");
    case Flaw::Kind::inside_out:
      break;
  }
  return fault("the surface is inside out: its normals point into the jar",
               "draw the inner volume as a solid, or flip all normals and export again",
               "mesh-inside-out");
}

Choice mesh_origin() {
  return {"origin",
          {"file", "centre"},
          "file",
          "as the file has it",
          "point of the mesh that is the centre of the jar",
          {"origin of the file", "middle of the extent of the mesh"}};
}

class MeshReader {
 public:
  MeshReader(SectionReader& in, Jar& jar) : in_(in), jar_(jar) {}

  void read() {
    const auto file = in_.text("file");
    if (!file && !in_.gives("file"))
      in_.missing("file", "the jar's inner surface", "write for instance file = \"my-jar.stl\"");
    const double scale = read_unit();
    const bool said = in_.gives("origin");
    const std::string origin = in_.choice(mesh_origin());
    const auto angle_field = Mesh::fields()[0];
    const double angle = in_.value(NumberSpec(angle_field));
    if (!file || std::isnan(scale) || std::isnan(angle) || origin.empty()) return;
    jar_.mesh.file = *file;
    jar_.mesh.centred = origin == "centre";
    if (auto surface = surface_in(*file, scale)) {
      Mesh mesh(std::move(*surface), angle);
      if (jar_.mesh.centred || said || holds_origin(mesh)) jar_.shape = std::move(mesh);
    }
  }

 private:
  void fault(std::string what, std::string remedy, std::string_view code) {
    in_.fault(*in_.find("file"), std::move(what), std::move(remedy), code);
  }

  /// [m] Length of the file's unit; `invalid_value` after a fault.
  double read_unit() {
    const auto unit = in_.text("unit");
    if (!unit) {
      if (!in_.gives("unit"))
        in_.missing("unit", "the unit of the file's numbers, as an STL file has none",
                    "write for instance unit = \"mm\"");
      return invalid_value;
    }
    jar_.mesh.unit = *unit;
    try {
      return parse_in("1 " + *unit, "m");
    } catch (const UnitError& error) {
      in_.fault(*in_.find("unit"), fmt::format("unit = \"{}\": {}", *unit, error.what()),
                "write a unit of length: \"mm\", \"m\", \"um\"", "bad-quantity");
      return invalid_value;
    }
  }

  std::optional<Surface> surface_in(const std::string& name, double scale) {
    const auto path = std::filesystem::path(in_.findings().folder) / name;
    const std::string file = path.generic_string();
    std::error_code ignored;
    std::ifstream stream;
    if (std::filesystem::is_regular_file(path, ignored)) stream.open(path, std::ios::binary);
    if (!stream.is_open()) {
      fault(fmt::format("the mesh file {} cannot be read", file),
            "give its path relative to the case file", "no-such-file");
      return std::nullopt;
    }
    const std::string bytes{std::istreambuf_iterator<char>(stream), {}};
    try {
      return closed(read_stl(bytes, scale), file);
    } catch (const StlError& error) {
      fault(fmt::format("{}: {}", file, error.what()),
            "export the surface again as STL, binary or ASCII, with fewer triangles if they are "
            "too many",
            "bad-mesh-file");
      return std::nullopt;
    }
  }

  /// The triangles as one closed surface of a plausible size, centred if the case says so; no value
  /// after a fault.
  std::optional<Surface> closed(std::vector<geometry::Corners> triangles, const std::string& file) {
    std::vector<Vec3> points;
    for (const geometry::Corners& c : triangles) points.insert(points.end(), c.begin(), c.end());
    const geometry::Extent e = geometry::extent_of(points);
    const double size = std::max({e.size().x, e.size().y, e.size().z});
    if (!(size <= widest) || !(size >= narrowest)) {
      in_.fault(*in_.find("unit"),
                fmt::format("the jar is {} wide: is the unit {}?", show_rounded(size, "m"),
                            jar_.mesh.unit),
                fmt::format("give the unit the file was drawn in; jars are from {} to {} wide",
                            show(narrowest, "m"), show(widest, "m")),
                "mesh-size");
      return std::nullopt;
    }
    if (jar_.mesh.centred)
      for (geometry::Corners& c : triangles)
        for (Vec3& p : c) p -= e.middle();
    Surface surface = geometry::weld(triangles);
    if (const auto flaw = geometry::flaw_of(surface)) {
      const Fault f = mesh_fault(*flaw, file);
      fault(f.what, f.remedy, f.code);
      return std::nullopt;
    }
    return surface;
  }

  /// Whether the file's origin lies within the jar; a fault otherwise. The jar rotates about it.
  bool holds_origin(const Mesh& mesh) {
    bool outside = false;
    mesh.near({}, 0, [&](int, const geometry::Gap& gap) { outside = !(gap.distance > 0); });
    if (outside)
      fault(fmt::format("the origin of the file lies outside the jar, {} from the middle of its "
                        "extent",
                        show_rounded(norm(mesh.extent().middle()), "m")),
            "write origin = \"centre\" to turn the jar about that middle, or origin = \"file\" if "
            "the mill's axis is meant to pass there",
            "origin-outside");
    return !outside;
  }

  SectionReader& in_;
  Jar& jar_;
};

}  // namespace

void describe_mesh(KeyVisitor& v, Jar& jar) {
  if (SectionReader* in = v.reader()) return MeshReader(*in, jar).read();
  v.custom(
      {"file", "inner surface of the jar (STL), relative to the case file", true, "text", true},
      [&] { return in_quotes(jar.mesh.file); });
  v.custom({.key = "unit",
            .about = "unit of length of the numbers in the file",
            .type = "text",
            .required = true,
            .presentation = {.start = "mm"}},
           [&] { return in_quotes(jar.mesh.unit); });
  v.word(mesh_origin(), jar.mesh.centred);
}

}  // namespace mahlwerk::cases
