// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// STL files: triangles by their corners, binary or as text. Their normals are not read: the order
// of the corners says the same, and always does.
namespace mahlwerk::cases {

/// Why bytes are no STL, in a sentence without a full stop.
class StlError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The triangles of an STL, times `scale`. Whether it is binary is told by its length, for many
/// binary ones begin with "solid" as texts do.
std::vector<geometry::Corners> read_stl(std::string_view bytes, double scale);

/// A surface as a text that read_stl() takes, to the last bit.
std::string stl_text(const geometry::Surface& surface);

constexpr std::size_t most_triangles = 4'000'000;  ///< about half a kilobyte each

}  // namespace mahlwerk::cases
