// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// Files of triangles: STL, OBJ and PLY.
namespace mahlwerk::cases {

/// Invalid mesh data; the message is a sentence without a full stop.
class MeshFileError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

constexpr std::size_t max_triangles = 4'000'000;  ///< of about 500 bytes of memory each

/// The triangles of a mesh file; coordinates are multiplied by `scale`. PLY is known by its first
/// word, OBJ by the ending of `name`, other files are read as STL. Throws MeshFileError.
std::vector<geometry::Corners> read_mesh_file(std::string_view bytes, std::string_view name,
                                              double scale);

// The formats, each with the same rules as read_mesh_file().

/// Wavefront OBJ. Polygons are cut into triangles from their first corner; groups, materials,
/// normals and textures are left out.
std::vector<geometry::Corners> read_obj(std::string_view text, double scale);
/// PLY in ASCII or in binary of either byte order: the elements `vertex` and `face`; polygons as
/// in OBJ.
std::vector<geometry::Corners> read_ply(std::string_view bytes, double scale);

/// The triangles of polygons, given by the numbers of their corners. Throws MeshFileError for
/// numbers that no vertex has, and for too many triangles.
class PolygonList {
 public:
  explicit PolygonList(double scale) : scale_(scale) {}

  void add_vertex(double x, double y, double z) {
    vertices_.push_back({scale_ * x, scale_ * y, scale_ * z});
  }
  std::size_t vertices() const { return vertices_.size(); }
  /// `corners` count from 0. `what` names the polygon in messages: "the face in line 3".
  void add_polygon(const std::vector<std::int64_t>& corners, const std::string& what);
  std::vector<geometry::Corners> triangles() && { return std::move(triangles_); }

 private:
  double scale_;
  std::vector<Vec3> vertices_;
  std::vector<geometry::Corners> triangles_;
};

}  // namespace mahlwerk::cases
