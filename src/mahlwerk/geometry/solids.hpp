// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <variant>

#include "mahlwerk/geometry/mesh_solid.hpp"
#include "mahlwerk/geometry/solid.hpp"

namespace mahlwerk::geometry {

/// The register of solids: what a part in a jar may be.
struct AnySolid : std::variant<PlaneSolid, DiscSolid, RingSolid, CylinderSolid, ConeSolid,
                               BladeSolid, MeshSolid> {
  using Models = std::variant<PlaneSolid, DiscSolid, RingSolid, CylinderSolid, ConeSolid,
                              BladeSolid, MeshSolid>;
  using Models::Models;
  bool operator==(const AnySolid&) const = default;
};

std::string_view name_of(const AnySolid& solid);  ///< "disc"

}  // namespace mahlwerk::geometry
