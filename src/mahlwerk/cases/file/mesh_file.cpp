// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/mesh_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "mahlwerk/base/admission.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/file/stl.hpp"

namespace mahlwerk::cases {
namespace {

bool ends_with_ignoring_case(std::string_view name, std::string_view lower) {
  return name.size() >= lower.size() &&
         std::ranges::equal(name.substr(name.size() - lower.size()), lower, [](char a, char b) {
           return std::tolower(static_cast<unsigned char>(a)) == b;
         });
}

bool is_ply(std::string_view bytes) {
  return bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
}

void refuse_far_corners(const std::vector<geometry::Corners>& all) {
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const Vec3& corner : all[i])
      for (const double coordinate : {corner.x, corner.y, corner.z})
        if (const std::string refused = refusal(coordinate, any_number, "m"); !refused.empty())
          throw MeshFileError(fmt::format(
              "a corner of triangle {} is {}: is it in the stated unit?", i + 1, refused));
}

}  // namespace

void PolygonList::add_polygon(const std::vector<std::int64_t>& corners, const std::string& what) {
  if (corners.size() < 3)
    throw MeshFileError(fmt::format("{} has {} corners", what, corners.size()));
  for (const std::int64_t corner : corners)
    if (corner < 0 || !std::cmp_less(corner, vertices_.size()))
      throw MeshFileError(fmt::format("{} has a corner that is none of the {} vertices before it",
                                      what, vertices_.size()));
  const auto at = [&](std::size_t k) { return vertices_[static_cast<std::size_t>(corners[k])]; };
  for (std::size_t k = 1; k + 1 < corners.size(); ++k)
    triangles_.push_back({at(0), at(k), at(k + 1)});
  if (triangles_.size() > max_triangles)
    throw MeshFileError(fmt::format("it has more triangles than the limit of {}", max_triangles));
}

std::vector<geometry::Corners> read_mesh_file(std::string_view bytes, std::string_view name,
                                              double scale) {
  if (bytes.empty()) throw MeshFileError("it is empty");
  std::vector<geometry::Corners> all = is_ply(bytes) ? read_ply(bytes, scale)
                                       : ends_with_ignoring_case(name, ".obj")
                                           ? read_obj(bytes, scale)
                                           : read_stl(bytes, scale);
  if (all.empty()) throw MeshFileError("it has no triangles");
  refuse_far_corners(all);
  return all;
}

}  // namespace mahlwerk::cases
