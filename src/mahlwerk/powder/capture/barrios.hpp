// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/powder/nip.hpp"

namespace mahlwerk::powder {

/// A bed one grain high (Barrios, de Carvalho and Tavares 2011; Mhadhbi 2021 eqs. 12 to 16).
struct Barrios {
  static constexpr std::string_view name = "barrios";
  static constexpr std::string_view about = "a bed one grain high, pressed by the collision";
  /// [J/kg] >= 0; 0: that of the breakage model, which must have one
  double fracture_energy = 0;
  static constexpr auto fields() {
    return std::array{
        Field<Barrios>{"fracture_energy", "J/kg", &Barrios::fracture_energy, not_negative,
                       "median specific energy that breaks grains of the bed, E_50b; 0: that of "
                       "the breakage model"}};
  }

  /// Capture by a collision of `energy` [J] >= 0. The deformation of the bed depends on the
  /// specific energy of its mass, which depends on the deformation: solved to 1e-13 (cap.5 to
  /// cap.9).
  Capture capture(const Nip& nip, double energy, const Grain& grain) const;
  bool operator==(const Barrios&) const = default;
};

/// [1] Relative deformation of a bed, 0 to 0.362, for a specific energy in units of E_50b (cap.8).
double bed_deformation(double energy_over_fracture_energy);
/// [m] Radius of capture of a bed that is deformed by `deformation` [m] (cap.6).
double capture_radius(const Nip& nip, double energy, double deformation);
/// [1] Grains of `size` [m] in a bed of that radius [m] (cap.5).
double grains_in_bed(double radius, double size);

}  // namespace mahlwerk::powder
