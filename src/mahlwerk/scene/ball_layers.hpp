// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>

namespace mahlwerk::scene {

/// Structure of a ball: a core, solid or hollow, and a coating around it (hol.1, hol.2).
struct BallLayers {
  double density = 0;                    ///< [kg/m3] of the core
  std::optional<double> wall_thickness;  ///< [m] of a hollow core; none: solid
  double coating_thickness = 0;          ///< [m] 0: no coating
  double coating_density = 0;            ///< [kg/m3]

  bool layered() const { return wall_thickness.has_value() || coating_thickness > 0; }

  /// Mass over the volume of the sphere [kg/m3], of a ball of `radius` [m] (hol.1).
  double mean_density(double radius) const { return layered() ? moment(radius, 3) : density; }
  /// Moment of inertia over mass and squared radius [1] (hol.2).
  double inertia_ratio(double radius) const {
    constexpr double solid = 0.4;
    return layered() ? solid * moment(radius, 5) / moment(radius, 3) : solid;
  }

 private:
  /// Density [kg/m3] of the homogeneous ball whose integral of r^(power - 1) over the density is
  /// the same.
  double moment(double radius, int power) const {
    const auto share = [&](double depth) {  // of a ball that is smaller by `depth`
      const double ratio = std::max(0.0, 1 - depth / radius);
      double product = 1;
      for (int i = 0; i < power; ++i) product *= ratio;
      return product;
    };
    const double core = share(coating_thickness);
    const double hole = wall_thickness ? share(coating_thickness + *wall_thickness) : 0.0;
    return density * (core - hole) + coating_density * (1 - core);
  }
};

}  // namespace mahlwerk::scene
