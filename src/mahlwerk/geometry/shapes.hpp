// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <type_traits>
#include <variant>

#include "mahlwerk/geometry/any_shape.hpp"
#include "mahlwerk/geometry/attritor.hpp"
#include "mahlwerk/geometry/box.hpp"
#include "mahlwerk/geometry/capsule.hpp"
#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/lifter_cylinder.hpp"
#include "mahlwerk/geometry/mesh.hpp"
#include "mahlwerk/geometry/periodic_box.hpp"
#include "mahlwerk/geometry/periodic_cylinder.hpp"
#include "mahlwerk/geometry/periodic_lifter_cylinder.hpp"
#include "mahlwerk/geometry/rounded_cylinder.hpp"
#include "mahlwerk/geometry/sphere.hpp"

namespace mahlwerk::geometry {

template <class... Formulas>
struct Register {
  using Formula = std::variant<Formulas...>;
  using Any = std::variant<Formulas..., PeriodicCylinder, LifterCylinder, PeriodicLifterCylinder,
                           Attritor, Mesh>;
};
/// The register of all jar shapes. To add one, write its file and add its name here.
using Shapes = Register<Capsule, Cylinder, RoundedCylinder, Sphere, Box, PeriodicBox>;

/// Convex analytic shapes, whose touches are exact: for both engines.
using FormulaShape = Shapes::Formula;
/// All shapes, with those for the soft engine only. A class rather than an alias, so that
/// any_shape.hpp can declare it.
struct AnyShape : Shapes::Any {
  using Models = Shapes::Any;
  using Models::Models;
};

template <class S, class Variant>
constexpr bool is_among = false;
template <class S, class... Shapes>
constexpr bool is_among<S, std::variant<Shapes...>> = (std::is_same_v<S, Shapes> || ...);
/// Whether the event engine can compute when a ball touches the shape.
template <class S>
constexpr bool has_exact_touches = is_among<S, FormulaShape>;

}  // namespace mahlwerk::geometry
