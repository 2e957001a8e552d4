// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "mahlwerk/base/field.hpp"

namespace mahlwerk::geometry {

/// The angle that divides a surface of triangles into faces (geo.9), of a jar or of a part.
template <class M>
constexpr Field<M> crease_angle_field() {
  return {"crease_angle",
          "rad",
          &M::crease_angle,
          Range{.least = 0, .most = std::numbers::pi, .without_least = true, .without_most = true},
          "triangles that bend by less belong to one face",
          std::numbers::pi / 6,
          "30 deg: facets of a round surface bend by less, edges by more"};
}

}  // namespace mahlwerk::geometry
