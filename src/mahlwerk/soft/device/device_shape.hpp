// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <concepts>
#include <type_traits>

#include "mahlwerk/geometry/lifter_cylinder.hpp"
#include "mahlwerk/geometry/mesh.hpp"
#include "mahlwerk/geometry/mesh_wall.hpp"
#include "mahlwerk/geometry/periodic_lifter_cylinder.hpp"

// Shapes as kernels read them: values, or addresses of arrays in the memory of the device.
namespace mahlwerk::soft {

/// What stands for a shape on a device: itself, where it is a plain value.
template <class S>
struct DeviceShapeOf {
  using Type = S;
};

/// A drum with bars, whose angles follow from their numbers.
struct FlatLifterCylinder {
  geometry::Cylinder shell;
  geometry::BarSection section;
  double lifters = 0;

  geometry::Gap gap(int face, const Vec3& p) const {
    if (face < 3) return shell.gap(face, p);
    return section.gap(sin_cos(geometry::bar_angle(face - 3, lifters)), p, geometry::never);
  }
  bool can_touch(int, double) const { return true; }
};
template <>
struct DeviceShapeOf<geometry::LifterCylinder> {
  using Type = FlatLifterCylinder;
};

/// The same without ends.
struct FlatPeriodicLifterCylinder {
  FlatLifterCylinder drum;

  geometry::Gap gap(int face, const Vec3& p) const { return drum.gap(face == 0 ? 0 : face + 2, p); }
  bool can_touch(int, double) const { return true; }
};
template <>
struct DeviceShapeOf<geometry::PeriodicLifterCylinder> {
  using Type = FlatPeriodicLifterCylinder;
};

template <>
struct DeviceShapeOf<geometry::Mesh> {
  using Type = geometry::MeshView;
};

template <class S>
using DeviceShape = typename DeviceShapeOf<S>::Type;

/// What kernels read. `copy(vector)` copies elements to the device and returns their address there.
template <class S, class Copy>
DeviceShape<S> device_shape(const S& shape, const Copy& copy) {
  if constexpr (std::same_as<S, geometry::LifterCylinder>)
    return {shape.shell(), shape.section(), shape.lifters};
  else if constexpr (std::same_as<S, geometry::PeriodicLifterCylinder>)
    return {{shape.drum.shell(), shape.drum.section(), shape.lifters}};
  else if constexpr (std::same_as<S, geometry::Mesh>)
    return shape.wall() != nullptr ? shape.wall()->view(copy) : geometry::MeshView{};
  else
    return shape;
}

}  // namespace mahlwerk::soft
