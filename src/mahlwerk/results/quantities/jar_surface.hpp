// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/base/rotation.hpp"
#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/scene/chamber.hpp"

// The jar's inner wall as triangles, for viewers.
namespace mahlwerk::results {

/// A closed surface in the jar's own axes. Triangles are anticlockwise seen from outside of the
/// enclosed volume: balls are inside of a jar and outside of a rotor.
struct JarMesh {
  std::string name;            ///< "jar" or "rotor", or the name of a part
  std::vector<Vec3> vertices;  ///< [m], all on the wall
  std::vector<std::array<std::uint32_t, 3>> triangles;
  bool rotor = false;  ///< rotates about z relative to the jar: see rotor_turn
};

/// The jar, and its rotor if it has one, at time 0. `facets`, a multiple of 16: facets around a
/// round wall; rotor arms have a quarter of them. With 96 facets a surface has fewer than 20 000
/// triangles. A jar from a mesh file keeps its triangles. A periodic box is a box.
std::vector<JarMesh> jar_surface(const geometry::AnyShape& shape, std::uint32_t facets = 96);

/// The parts of a chamber, each in its own axes. A plane is drawn as wide as the jar.
std::vector<JarMesh> own_part_surfaces(const scene::Chamber& mill, std::uint32_t facets = 48);
/// The same, each in its frame before its motion: see scene::part_pose().
std::vector<JarMesh> part_surfaces(const scene::Chamber& mill, std::uint32_t facets = 48);

/// Rotation of the rotor in the jar's own axes at the time [s] of its mill (kinematics::Clock).
Rotation rotor_turn(const geometry::AnyShape& shape, double time);

}  // namespace mahlwerk::results
