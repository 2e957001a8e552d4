// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/nip.hpp"

namespace mahlwerk::powder {

/// Powder coats the balls; the layer within the contact area is captured (Maurice and Courtney
/// 1990, Bhattacharya and Arzt 1992).
struct TrappedVolume {
  static constexpr std::string_view name = "trapped-volume";
  static constexpr std::string_view about = "Hertz's contact area times the coating's thickness";
  double thickness = 0;  ///< [m] > 0 thickness of the powder between both bodies, h_0
  double packing = 0.6;  ///< [1] > 0 volume share of the solid in the powder
  static constexpr auto fields() {
    constexpr Range shares{.least = 0, .most = 1, .without_least = true};
    return std::array{
        Field<TrappedVolume>{"thickness", "m", &TrappedVolume::thickness, positive,
                             "thickness of the powder between two bodies that touch, h_0"},
        Field<TrappedVolume>{"packing", "", &TrappedVolume::packing, shares,
                             "volume share of the solid in the powder", 0.6,
                             "random packing of spheres, loose 0.55 to dense 0.64"}};
  }
  Capture capture(const Nip& nip, double energy, const Grain& grain) const {  // (cap.10)
    const double a = contact_radius(nip, energy);
    return capture_of_mass(packing * grain.density * std::numbers::pi * a * a * thickness, grain,
                           a);
  }
  bool operator==(const TrappedVolume&) const = default;
};

}  // namespace mahlwerk::powder
