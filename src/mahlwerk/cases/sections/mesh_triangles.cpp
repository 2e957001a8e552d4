// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/sections/mesh_triangles.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "mahlwerk/base/units.hpp"

namespace mahlwerk::cases {
namespace {

using geometry::Flaw;

std::string position_text(const Vec3& p) {
  return fmt::format("({:.4g}, {:.4g}, {:.4g}) mm", 1e3 * p.x, 1e3 * p.y, 1e3 * p.z);
}

std::string edges(std::size_t count) {
  return count == 1 ? "1 edge" : fmt::format("{} edges", count);
}

/// [m] Length of the file's unit; `invalid_value` after a fault.
double read_unit(SectionReader& in, std::string& unit) {
  const auto given = in.text("unit");
  if (!given) {
    if (!in.gives("unit"))
      in.missing("unit", "the unit of the file's numbers, as mesh files have none",
                 "write for instance unit = \"mm\"");
    return invalid_value;
  }
  unit = *given;
  try {
    return parse_in("1 " + unit, "m");
  } catch (const UnitError& error) {
    in.fault(*in.find("unit"), fmt::format("unit = \"{}\": {}", unit, error.what()),
             "write a unit of length: \"mm\", \"m\", \"um\"", "bad-quantity");
    return invalid_value;
  }
}

/// The bytes of a regular file; no value if it cannot be read.
std::optional<std::string> bytes_of(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream stream;
  if (std::filesystem::is_regular_file(path, ignored)) stream.open(path, std::ios::binary);
  if (!stream.is_open()) return std::nullopt;
  return std::string{std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

std::optional<MeshTriangles> read_mesh_triangles(SectionReader& in, std::string_view about,
                                                 const TriangleReader& read) {
  const auto file = in.text("file");
  if (!file && !in.gives("file"))
    in.missing("file", about, "write for instance file = \"my-mesh.stl\"");
  MeshTriangles found;
  const double scale = read_unit(in, found.unit);
  if (!file || std::isnan(scale)) return std::nullopt;
  const auto path = std::filesystem::path(in.findings().folder) / *file;
  found.file = *file;
  found.path = path.generic_string();
  const auto bytes = bytes_of(path);
  if (!bytes) {
    in.fault(*in.find("file"), fmt::format("the mesh file {} cannot be read", found.path),
             "give its path relative to the case file", "no-such-file");
    return std::nullopt;
  }
  try {
    found.triangles = read(*bytes, *file, scale);
    return found;
  } catch (const MeshFileError& error) {
    in.fault(*in.find("file"), fmt::format("{}: {}", found.path, error.what()),
             file->ends_with(".csv")
                 ? "write the corners of a closed polygon, one \"x,y\" in each line after the first"
                 : "export the surface again as STL, OBJ or PLY, with fewer triangles if they are "
                   "too many",
             "bad-mesh-file");
    return std::nullopt;
  }
}

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

}  // namespace mahlwerk::cases
