// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sections/part_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/mesh_triangles.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/geometry/solids.hpp"

namespace mahlwerk::cases {
namespace {

using geometry::MeshSolid;

constexpr double widest = 100, narrowest = 1e-4;  // [m] plausible widths of a part

/// Whether the size of the mesh is plausible; a fault otherwise.
bool plausible(SectionReader& in, const MeshTriangles& found) {
  std::vector<Vec3> points;
  for (const geometry::Corners& c : found.triangles)
    points.insert(points.end(), c.begin(), c.end());
  const Vec3 sides = geometry::extent_of(points).size();
  const double size = std::max({sides.x, sides.y, sides.z});
  if (size <= widest && size >= narrowest) return true;
  in.fault(*in.find("unit"),
           fmt::format("the part is {} wide: is the unit {}?", show_rounded(size, "m"), found.unit),
           fmt::format("give the unit the file was drawn in; parts are from {} to {} wide",
                       show(narrowest, "m"), show(widest, "m")),
           "mesh-size");
  return false;
}

}  // namespace

void describe_part_mesh(KeyVisitor& v, MachinePart& part) {
  v.custom({"file", "triangles of the part (STL, OBJ, PLY), relative to the case file", true,
            "text", true},
           [&] { return in_quotes(part.file); });
  v.custom({.key = "unit",
            .about = "unit of length of the numbers in the file",
            .type = "text",
            .required = true,
            .presentation = {.start = "mm"}},
           [&] { return in_quotes(part.unit); });
}

void read_part_mesh(SectionReader& in, MachinePart& part) {
  auto found = read_mesh_triangles(in, "the triangles of the part");
  const auto angle_field = MeshSolid::fields()[0];
  const double angle = in.value(NumberSpec(angle_field));
  if (!found || std::isnan(angle)) return;
  part.file = found->file, part.unit = found->unit;
  if (!plausible(in, *found)) return;
  geometry::Surface surface = geometry::weld(found->triangles);
  if (surface.triangles.empty())
    return in.fault(*in.find("file"),
                    fmt::format("{}: none of its triangles has an area", found->path),
                    "export the surface again", "bad-mesh-file");
  if (const auto flaw = geometry::flaw_of_part(surface)) {
    const Fault f = mesh_fault(*flaw, found->path);
    return in.fault(*in.find("file"), f.what, f.remedy, f.code);
  }
  MeshSolid solid(std::move(surface), angle);
  if (solid.is_sheet() && !solid.is_flat())
    return in.fault(
        *in.find("file"),
        fmt::format("{}: the surface is open and not flat: balls at the edges of a curved "
                    "sheet without thickness would gain energy",
                    found->path),
        "close the surface, with a thickness of for instance 2 mm", "bad-mesh-file");
  if (solid.is_sheet())
    in.findings().remarks.push_back(
        note("part-is-a-sheet",
             fmt::format("[[{}]]: the surface of {} is open: the part is a sheet without "
                         "thickness, which balls touch from both sides.",
                         in.name(), found->path)));
  part.body.solid = std::move(solid);
}

void describe_part_motion_file(KeyVisitor& v, MachinePart& part) {
  SectionReader* in = v.reader();
  if (in == nullptr)
    return v.text(
        {"motion_file", "table of the measured motion (CSV), relative to the case file", true},
        part.motion_file);
  const auto file = in->text("motion_file");
  if (!file) {
    if (!in->gives("motion_file"))
      in->missing("motion_file", "the measured motion",
                  "write for instance motion_file = \"motion.csv\"");
    return;
  }
  part.motion_file = *file;
  const auto path = std::filesystem::path(in->findings().folder) / *file;
  kinematics::PartMotion& m = part.body.motion;
  m.path = read_motion_file(path.generic_string(), {0, 0, 1}, *in->find("motion_file"),
                            in->findings(), &m.lean);
}

}  // namespace mahlwerk::cases
