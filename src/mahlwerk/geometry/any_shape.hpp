// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/indirect.hpp"
#include "mahlwerk/base/vec3.hpp"

// A jar shape chosen at run time, for those who do not look into it; geometry/shapes.hpp lists what
// it can be.
namespace mahlwerk::geometry {

struct AnyShape;

std::string_view name_of(const AnyShape& shape);  ///< "cylinder"
/// Whether the event engine takes it.
bool exact_touches(const AnyShape& shape);
int faces(const AnyShape& shape);
std::vector<std::string> face_names(const AnyShape& shape);
/// Whether its own z axis is an axis of rotation.
bool axisymmetric(const AnyShape& shape);
double inradius(const AnyShape& shape);        ///< [m] of the largest ball that fits
double reach(const AnyShape& shape);           ///< [m] of its farthest point from its origin
double volume(const AnyShape& shape);          ///< [m3]
Vec3 periods(const AnyShape& shape);           ///< [m] as periods_of() in geometry/shape.hpp
double speed_of_parts(const AnyShape& shape);  ///< [m/s] of a stirrer's tips; 0 without one
/// Why there is no such shape, as a sentence without its end; empty if nothing is wrong.
std::string flaw(const AnyShape& shape);
/// [m] from the nearest wall to `p`, in the jar's own axes: exact within `within`, larger than that
/// elsewhere, negative outside.
double nearest_wall(const AnyShape& shape, const Vec3& p, double within);

/// What is held, of the type whose name is name_of().
const void* held(const AnyShape& shape);
/// The shape if it is one of type S, else null.
template <class S>
const S* as(const AnyShape& shape) {
  return name_of(shape) == S::name ? static_cast<const S*>(held(shape)) : nullptr;
}

}  // namespace mahlwerk::geometry
