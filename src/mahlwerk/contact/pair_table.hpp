// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>

#include "mahlwerk/contact/pairwise_table.hpp"

namespace mahlwerk::contact {

/// Elastic constants of a body.
struct ElasticConstants {
  double youngs_modulus = 0;  ///< [Pa] > 0; infinite: rigid
  double poisson_ratio = 0;   ///< [1] in (-1, 0.5]
  bool operator==(const ElasticConstants&) const = default;
};

/// Properties of a pair of bodies that a contact law reads, except radii and masses.
struct Pair {
  double modulus = 0;           ///< [Pa] E* (dem.2)
  double shear_modulus = 0;     ///< [Pa] G* (dem.3)
  double restitution = 1;       ///< [1] e in [0, 1]
  double friction = INFINITY;   ///< [1] mu >= 0; infinite: no sliding
  double rolling_friction = 0;  ///< [1] mu_r >= 0; [s/m] for the viscous rule
  double surface_energy = 0;    ///< [J/m2] gamma of one surface, for JKR
  double cohesion = 0;          ///< [J/m3] energy density, for SJKR
  double surface_tension = 0;   ///< [N/m] of the liquid of capillary bridges; 0: dry
  double hardness = 0;          ///< [Pa] of the softer body; 0: the pair never yields
  double softening = 1;         ///< [1] factor by which the moduli have been reduced
  bool operator==(const Pair&) const = default;
};

/// E* and G* of two bodies [Pa]; each is 1 / (sum of compliances) (dem.2, dem.3).
inline double effective_modulus(const ElasticConstants& a, const ElasticConstants& b) {
  const auto compliance = [](const ElasticConstants& x) {
    return (1 - x.poisson_ratio * x.poisson_ratio) / x.youngs_modulus;
  };
  return 1 / (compliance(a) + compliance(b));
}
inline double effective_shear_modulus(const ElasticConstants& a, const ElasticConstants& b) {
  const auto compliance = [](const ElasticConstants& x) {
    return 2 * (2 - x.poisson_ratio) * (1 + x.poisson_ratio) / x.youngs_modulus;
  };
  return 1 / (compliance(a) + compliance(b));
}

/// The properties of every pair.
using PairTable = PairwiseTable<Pair>;

}  // namespace mahlwerk::contact
