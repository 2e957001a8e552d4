// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/cases/file/mesh_file.hpp"
#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/geometry/surface.hpp"

namespace mahlwerk::cases {

/// Triangles of a section's mesh file, in m.
struct MeshTriangles {
  std::string file, unit;  ///< as written
  std::string path;        ///< of the file, for messages
  std::vector<geometry::Corners> triangles;
};

/// How the bytes of a file become triangles; throws MeshFileError.
using TriangleReader = std::function<std::vector<geometry::Corners>(
    std::string_view bytes, const std::string& file, double scale)>;

/// Reads the keys `file` and `unit` of a section and the file; no value after a fault. `about`
/// says what the file holds: "the jar's inner surface".
std::optional<MeshTriangles> read_mesh_triangles(SectionReader& in, std::string_view about,
                                                 const TriangleReader& read = read_mesh_file);

/// The fault of a surface whose triangles do not fit together.
Fault mesh_fault(const geometry::Flaw& flaw, const std::string& file);

}  // namespace mahlwerk::cases
