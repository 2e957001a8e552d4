// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/mesh_triangles.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::cases {
namespace {

using geometry::Mesh;
using geometry::Surface;

constexpr double widest = 10, narrowest = 1e-3;  // [m] plausible widths of a jar

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
    auto found = read_mesh_triangles(in_, "the jar's inner surface");
    const bool said = in_.gives("origin");
    const std::string origin = in_.choice(mesh_origin());
    const auto angle_field = Mesh::fields()[0];
    const double angle = in_.value(NumberSpec(angle_field));
    if (!found) return;
    jar_.mesh = {found->file, found->unit, origin == "centre"};
    if (std::isnan(angle) || origin.empty()) return;
    if (auto surface = closed(std::move(found->triangles), found->path)) {
      Mesh mesh(std::move(*surface), angle);
      if (jar_.mesh.centred || said || holds_origin(mesh)) jar_.shape = std::move(mesh);
    }
  }

 private:
  void fault(std::string what, std::string remedy, std::string_view code) {
    in_.fault(*in_.find("file"), std::move(what), std::move(remedy), code);
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
  v.custom({"file", "inner surface of the jar (STL, OBJ, PLY), relative to the case file", true,
            "text", true},
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
