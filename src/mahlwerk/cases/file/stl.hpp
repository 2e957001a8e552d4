// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// STL files, binary or ASCII. Normals are not read: the order of the corners gives the orientation
// of a triangle.
namespace mahlwerk::cases {

/// The triangles of an STL file; coordinates are multiplied by `scale`. The length of the file
/// decides whether it is binary, because many binary files begin with "solid" like ASCII files.
/// Throws MeshFileError.
std::vector<geometry::Corners> read_stl(std::string_view bytes, double scale);

/// A surface as ASCII STL; read_stl() restores every coordinate exactly.
std::string stl_text(const geometry::Surface& surface);

}  // namespace mahlwerk::cases
