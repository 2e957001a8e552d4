// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "mahlwerk/geometry/box.hpp"
#include "mahlwerk/geometry/capsule.hpp"
#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/sphere.hpp"
#include "mahlwerk/scene/typed_chamber.hpp"

namespace mahlwerk::lammps {

/// A jar that LAMMPS has a region for, on its mill.
class Jar {
 public:
  /// The shape must have has_region() (jar_terms.hpp).
  explicit Jar(const scene::Chamber& chamber);

  int faces() const { return faces_; }
  /// The wall at a ball of `radius` [m] at `position` [m] in the jar frame, at mill time `t` [s].
  scene::Wall wall(int face, const Vec3& position, double t, double radius) const {
    return std::visit([&](const auto& jar) { return jar.wall(face, position, t, radius); }, jar_);
  }
  /// Transforms a vector from the jar frame to the jar's own, rotating axes.
  Vec3 to_jar_axes(const Vec3& a, double t) const {
    return std::visit([&](const auto& jar) { return jar.to_jar_axes(a, t); }, jar_);
  }

 private:
  template <class S>
  using Typed = scene::TypedChamber<S>;
  using Any = std::variant<Typed<geometry::Cylinder>, Typed<geometry::Capsule>,
                           Typed<geometry::Sphere>, Typed<geometry::Box>>;
  static Any make(const scene::Chamber& chamber);
  Any jar_;
  int faces_;
};

}  // namespace mahlwerk::lammps
