// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/scene/balls.hpp"

// How well balls of two colours are mixed, and how densely they are packed, at an instant.
namespace mahlwerk::observe {

/// Degree of mixing: 0 separated, 1 as a random mixture.
struct MixingIndex {
  double lacey = 0;       ///< (mix.1); NaN with too few balls
  double neighbours = 0;  ///< (mix.2); NaN if no ball has neighbours
};
/// `colours` is 0 or 1 for each ball; `cell` [m] is the side of the cubes whose contents are
/// compared; balls nearer than `reach` [m] are neighbours.
MixingIndex mixing_index(std::span<const scene::Ball> balls, std::span<const std::uint8_t> colours,
                         double cell, double reach);

/// Packing fraction around a point: volume of balls within the sphere of `radius` [m] about it over
/// the volume of that sphere (mix.5). Exact for balls that do not overlap.
double packing_around(std::span<const scene::Ball> balls, const Vec3& point, double radius);
/// [m3] Volume common to two spheres whose centres are `distance` [m] apart.
double common_volume(double a, double b, double distance);

}  // namespace mahlwerk::observe
