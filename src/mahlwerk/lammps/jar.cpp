// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/jar.hpp"

#include "mahlwerk/geometry/shapes.hpp"

namespace mahlwerk::lammps {

Jar::Any Jar::make(const scene::Chamber& chamber) {
  const kinematics::ChosenMotion motion(chamber.motion);
  const geometry::AnyShape& shape = *chamber.shape;
  if (const auto* s = geometry::as<geometry::Capsule>(shape))
    return Typed<geometry::Capsule>(*s, motion, chamber);
  if (const auto* s = geometry::as<geometry::Sphere>(shape))
    return Typed<geometry::Sphere>(*s, motion, chamber);
  if (const auto* s = geometry::as<geometry::Box>(shape))
    return Typed<geometry::Box>(*s, motion, chamber);
  return Typed<geometry::Cylinder>(*geometry::as<geometry::Cylinder>(shape), motion, chamber);
}

Jar::Jar(const scene::Chamber& chamber)
    : jar_(make(chamber)), faces_(geometry::faces(*chamber.shape)) {}

}  // namespace mahlwerk::lammps
