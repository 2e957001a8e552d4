// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>

#include "mahlwerk/base/vec3.hpp"

namespace mahlwerk::geometry {

/// The facets of a face around the nearest point of a place, kept between the queries of a ball
/// that moves little. They save time only: a query near that place gives the same bits as a search
/// over the whole face, and elsewhere it renews them. So they belong to no state and no checkpoint.
struct NearFacets {
  struct Listed {
    std::int32_t facet = -1;
    float from = 0;  ///< [m] not the nearest one as long as the ball is nearer than that to `place`
  };
  static constexpr std::size_t most = 16;

  std::array<Listed, most> list;  ///< in the order of `from`
  std::size_t count = 0;          ///< 0: the whole face is beyond `range`
  int face = -1;                  ///< none yet
  Vec3 place;                     ///< [m]
  double range = 0;               ///< [m]
  double others_from = 0;         ///< [m] `from` of all other facets, at least
};

}  // namespace mahlwerk::geometry
