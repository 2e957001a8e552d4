// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "mahlwerk/geometry/box.hpp"
#include "mahlwerk/geometry/capsule.hpp"
#include "mahlwerk/geometry/cylinder.hpp"
#include "mahlwerk/geometry/mesh.hpp"
#include "mahlwerk/geometry/periodic_box.hpp"
#include "mahlwerk/geometry/rounded_cylinder.hpp"
#include "mahlwerk/geometry/sphere.hpp"

namespace mahlwerk::geometry {

template <class... Formulas>
struct Register {
  using Formula = std::variant<Formulas...>;
  using Any = std::variant<Formulas..., Mesh>;
};
/// The register: every jar shape there is. A new one is its file and its name here.
using Shapes = Register<Capsule, Cylinder, RoundedCylinder, Sphere, Box, PeriodicBox>;

using FormulaShape = Shapes::Formula;  ///< those that a formula describes: what every engine takes
using AnyShape = Shapes::Any;          ///< and meshes

}  // namespace mahlwerk::geometry
