// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/geometry/any_shape.hpp"

// What a jar looks like: its inner wall as triangles, for viewers.
namespace mahlwerk::results {

/// A closed surface in the jar's own axes. Its triangles run anticlockwise as seen from outside of
/// what it encloses: balls are inside of a jar and outside of a rotor.
struct JarMesh {
  std::string name;            ///< "jar" or "rotor"
  std::vector<Vec3> vertices;  ///< [m], all on the wall
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool rotor = false;  ///< turns by itself, about z: see rotor_turn
};

/// The jar, and its rotor where it has one, as it stands at first. Round walls are cut into so many
/// facets all round, a multiple of 16, arms of a rotor into a quarter of that; with 96 surfaces
/// stay below 20 000 triangles. One that was read from a file is as it was. A periodic box is drawn
/// as a box.
std::vector<JarMesh> jar_surface(const geometry::AnyShape& shape, std::uint32_t facets = 96);

/// How the rotor has turned in the jar's own axes at `time` [s] since the start.
Rotation rotor_turn(const geometry::AnyShape& shape, double time);

}  // namespace mahlwerk::results
