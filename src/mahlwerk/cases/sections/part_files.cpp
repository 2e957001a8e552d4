// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sections/part_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/file/section_profile.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
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

bool is_section(std::string_view file) {
  return file.ends_with(".csv") || file.ends_with(".CSV");
}

void describe_section(KeyVisitor& v, MachinePart& part) {
  v.number({"length", "m", positive, "of a body with the section of the file, along its own axis"},
           part.length);
  v.integer({"rows", 1, 1000, "copies of a section, evenly about its own axis", 1, "one body"},
            part.rows);
}

/// The triangles of a part whose file is a section.
std::vector<geometry::Corners> extruded(std::string_view text, const MachinePart& part,
                                        double scale) {
  const geometry::Section section = read_section_profile(text, scale);
  const auto rows = static_cast<double>(part.rows);
  if (part.rows > 1 && geometry::angular_width(section) * rows >= 2 * std::numbers::pi)
    throw MeshFileError(fmt::format(
        "{} copies do not fit about the axis: the section is {:.3g} deg wide, seen from there",
        part.rows, geometry::angular_width(section) * 180 / std::numbers::pi));
  return geometry::prism(section, part.length, static_cast<int>(part.rows));
}

}  // namespace

void describe_part_mesh(KeyVisitor& v, MachinePart& part) {
  v.custom({"file",
            "triangles of the part (STL, OBJ, PLY), or a section of it (CSV); relative to the case "
            "file",
            true, "text", true},
           [&] { return in_quotes(part.file); });
  v.custom({.key = "unit",
            .about = "unit of length of the numbers in the file",
            .type = "text",
            .required = true,
            .presentation = {.start = "mm"}},
           [&] { return in_quotes(part.unit); });
  if (is_section(part.file)) return describe_section(v, part);
  if (!v.visits_all()) return;
  MachinePart bar;  // for lists of keys
  bar.length = 1;
  describe_section(v, bar);
}

void read_part_mesh(SectionReader& in, MachinePart& part) {
  const Node* file_key = in.find("file");
  const bool section = file_key != nullptr && is_section(file_key->text);
  if (section) describe_section(in, part);
  if (section && (!(part.length > 0) || part.rows < 1)) return in.ignore_unknown_keys();
  auto found = read_mesh_triangles(
      in, "the triangles of the part",
      [&](std::string_view bytes, const std::string& file, double scale) {
        return section ? extruded(bytes, part, scale) : read_mesh_file(bytes, file, scale);
      });
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
