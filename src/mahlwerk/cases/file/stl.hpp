// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// STL files, binary or ASCII. Normals are not read: the order of the corners gives the orientation
// of a triangle.
namespace mahlwerk::cases {

/// Invalid STL data; the message is a sentence without a full stop.
class StlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The triangles of an STL file; coordinates are multiplied by `scale`. The length of the file
/// decides whether it is binary, because many binary files begin with "solid" like ASCII files.
/// Throws StlError.
std::vector<geometry::Corners> read_stl(std::string_view bytes, double scale);

/// A surface as ASCII STL; read_stl() restores every coordinate exactly.
std::string stl_text(const geometry::Surface& surface);

constexpr std::size_t max_triangles = 4'000'000;  ///< of about 500 bytes of memory each

}  // namespace mahlwerk::cases
