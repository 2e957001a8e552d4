// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/balls.hpp"

// How well balls of two colours are mixed at an instant: 0 separated, 1 as a random mixture.
// `colours` is 0 or 1 for each ball. NaN of one colour.
namespace mahlwerk::observe {

/// Lacey's index (mix.1); `cell` [m] is the side of the cubes whose contents are compared. NaN with
/// too few balls.
double lacey_index(std::span<const scene::Ball> balls, std::span<const std::uint8_t> colours,
                   double cell);

/// Index of neighbours (mix.2), balls nearer than `reach` [m] and images of balls. `balls` are in
/// the jar's own axes, `periods` [m] as geometry::periods(). NaN if no ball has neighbours.
double neighbour_index(std::span<const scene::Ball> balls, std::span<const std::uint8_t> colours,
                       double reach, const Vec3& periods);

}  // namespace mahlwerk::observe
