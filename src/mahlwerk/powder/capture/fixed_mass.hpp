// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/nip.hpp"

namespace mahlwerk::powder {

/// A constant mass per collision.
struct FixedMass {
  static constexpr std::string_view name = "fixed";
  static constexpr std::string_view about =
      "the same mass in each collision, independent of its energy";
  double mass = 0;  ///< [kg] > 0
  static constexpr auto fields() {
    return std::array{Field<FixedMass>{"mass", "kg", &FixedMass::mass, positive,
                                       "mass that each collision catches"}};
  }
  Capture capture(const Nip& nip, double energy, const Grain& grain) const {
    return capture_of_mass(mass, grain, contact_radius(nip, energy));
  }
  bool operator==(const FixedMass&) const = default;
};

}  // namespace mahlwerk::powder
