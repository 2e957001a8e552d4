// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/nip.hpp"

namespace mahlwerk::powder {

/// Powder coats both bodies with a constant mass per area (Magini, Iasonna and Padella 1996).
struct SurfaceLayer {
  static constexpr std::string_view name = "surface-layer";
  static constexpr std::string_view about =
      "Hertz's contact area times twice the coating's mass per area";
  double surface_density = 0;  ///< [kg/m2] > 0 of powder on one body, sigma
  static constexpr auto fields() {
    return std::array{Field<SurfaceLayer>{"surface_density", "kg/m2",
                                          &SurfaceLayer::surface_density, positive,
                                          "mass of powder per area of a body, sigma"}};
  }
  Capture capture(const Nip& nip, double energy, const Grain& grain) const {  // (cap.11)
    const double a = contact_radius(nip, energy);
    return capture_of_mass(2 * surface_density * std::numbers::pi * a * a, grain, a);
  }
  bool operator==(const SurfaceLayer&) const = default;
};

}  // namespace mahlwerk::powder
