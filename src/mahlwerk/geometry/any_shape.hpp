// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <typeinfo>
#include <vector>

#include "mahlwerk/base/indirect.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/geometry/shape.hpp"

// Type-erased jar shape, chosen at run time. geometry/shapes.hpp lists the types it can hold.
namespace mahlwerk::geometry {

struct AnyShape;

std::string_view name_of(const AnyShape& shape);  ///< "cylinder"
/// Whether the event engine supports it.
bool exact_touches(const AnyShape& shape);
int faces(const AnyShape& shape);
std::vector<std::string> face_names(const AnyShape& shape);
/// Whether it is symmetric under rotation about its own z axis.
bool axisymmetric(const AnyShape& shape);
double inradius(const AnyShape& shape);           ///< [m] of the largest ball that fits
double reach(const AnyShape& shape);              ///< [m] of the point farthest from its origin
double radius_about_axis(const AnyShape& shape);  ///< [m] of the jar about its axis
double volume(const AnyShape& shape);             ///< [m3]
Vec3 periods(const AnyShape& shape);              ///< [m] as periods_of() in geometry/shape.hpp
double rotor_tip_speed(const AnyShape& shape);    ///< [m/s] of a stirrer's tips; 0 without one
/// Why the shape is impossible, as a sentence without its full stop; empty if it is valid.
std::string flaw(const AnyShape& shape);
/// Distance [m] from `p` [m], in the jar's own axes, to the nearest wall that a ball of `radius`
/// [m] at `p` can touch. Exact up to `radius`; some larger value beyond; negative outside.
double nearest_wall(const AnyShape& shape, const Vec3& p, double radius);

/// Pointer to the shape held if it is of this type, else null.
const void* held(const AnyShape& shape, const std::type_info& type);
/// The shape if it is an S, else null.
template <Shape S>
const S* as(const AnyShape& shape) {
  return static_cast<const S*>(held(shape, typeid(S)));
}
template <Shape S>
const S* as(const AnyShape&&) = delete;

}  // namespace mahlwerk::geometry
