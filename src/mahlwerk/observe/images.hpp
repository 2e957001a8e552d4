// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::observe {

/// The balls of a periodic jar with their images near it.
struct Images {
  std::vector<scene::Ball> balls;  ///< first the balls themselves, folded into the jar
  std::vector<std::uint32_t> of;   ///< the ball that each one is an image of
};

/// `balls` in the jar's own axes; images as far as `within` [m] beyond its boundaries, of however
/// many periods that is. `periods` [m] as geometry::periods().
Images images(std::span<const scene::Ball> balls, const Vec3& periods, double within);

/// A coordinate folded into the period about 0.
double folded(double x, double period);
Vec3 folded(const Vec3& p, const Vec3& periods);

}  // namespace mahlwerk::observe
