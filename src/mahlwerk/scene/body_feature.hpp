// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace mahlwerk::scene {

/// Where a body that is no sphere was hit (bod.16). An integer of 32 bits in collision records.
enum class BodyFeature : std::int32_t {
  none,    ///< of a sphere, an ellipsoid, a clump that stands for itself, and a wall
  face,    ///< flat: an end of a cylinder, a face of a cube
  edge,    ///< between two faces, or between the end and the side of a cylinder
  corner,  ///< between three faces
  side,    ///< the curved side of a cylinder or rod
  cap      ///< the rounded end of a rod
};
inline constexpr std::array body_features{BodyFeature::face, BodyFeature::edge, BodyFeature::corner,
                                          BodyFeature::side, BodyFeature::cap};
constexpr std::size_t index_of(BodyFeature feature) {  ///< in body_features; not of `none`
  return static_cast<std::size_t>(feature) - 1;
}
std::string_view name_of(BodyFeature feature);  ///< "face"

}  // namespace mahlwerk::scene
