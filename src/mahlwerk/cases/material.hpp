// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/pair_table.hpp"

// Properties of the materials of bodies, and their defaults.
namespace mahlwerk::cases {

/// Steel, the default material.
constexpr contact::ElasticConstants steel{.youngs_modulus = 210e9, .poisson_ratio = 0.3};

/// Material properties for wear and heat.
struct Substance {
  double hardness = 0;       ///< [1] Vickers number HV > 0
  double conductivity = 0;   ///< [W/(m K)] thermal conductivity > 0
  double heat_capacity = 0;  ///< [J/(kg K)] specific heat capacity > 0
  bool operator==(const Substance&) const = default;
};

/// Steel 1.4034, the material of many balls and jars: the default.
constexpr Substance hardened_steel{.hardness = 600, .conductivity = 30, .heat_capacity = 460};
constexpr double hardened_steel_density = 7730;  ///< [kg/m3]

}  // namespace mahlwerk::cases
