// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/law.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::soft {

/// A pair of ball species, or of a species and a face of the jar.
struct SpeciesPair {
  contact::EffectivePair effective;
  double damping = 0;  ///< coefficient of the law (contact::Law)
  contact::LawCoefficients coefficients{};
  double pull_off_distance = 0;  ///< [m]
  double stiffness_ratio = 0;    ///< [1]

  /// Correction of the tangential stiffness for the step dt [s], in m/N: k_t <- k_t (1 - lag k_t)
  /// (dem.37). The tangential spring of a ball swings too fast by w^2 dt^2/6 of its rate, with
  /// w^2 = (7/2) k_t/m*, so k_t is reduced by w^2 dt^2/3 = (7/6) (dt^2/m*) k_t.
  double stiffness_correction(double step) const {
    return 7.0 / 6.0 * step * step / effective.mass;
  }
};

/// Balls of the same size, density and kind.
struct Species {
  double radius = 0, density = 0, mass = 0, inertia = 0;
  std::int32_t kind = 0;
};

/// All species, and the law's coefficients for every pair of them.
class SpeciesPairs {
 public:
  SpeciesPairs(const std::vector<scene::Ball>& balls, const contact::PairTable& pairs,
               const contact::AnyLaw& law);

  std::int32_t species_of(std::size_t ball) const { return of_[ball]; }
  const Species& species(std::int32_t s) const { return species_[static_cast<std::size_t>(s)]; }
  const Species& of(std::size_t ball) const { return species(of_[ball]); }
  std::int32_t balls(std::int32_t a, std::int32_t b) const { return a * row_ + b; }
  std::int32_t wall(std::int32_t s, int face) const {
    return s * row_ + static_cast<std::int32_t>(species_.size()) + face;
  }
  const SpeciesPair& operator[](std::int32_t pair) const {
    return pairs_[static_cast<std::size_t>(pair)];
  }
  std::span<const SpeciesPair> all() const { return pairs_; }
  std::span<const Species> all_species() const { return species_; }

 private:
  std::vector<Species> species_;
  std::vector<std::int32_t> of_;  // species of each ball
  std::vector<SpeciesPair> pairs_;
  std::int32_t row_ = 0;
};

}  // namespace mahlwerk::soft
