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

  /// (w dt)^2 over k_t [m/N] for a step dt [s], w the frequency of the tangential spring:
  /// w^2 = s k_t/m*, s the slip factor (hol.4).
  double phase_squared_per_stiffness(double dt) const {
    return effective.slip_factor * dt * dt / effective.mass;
  }
};

/// Balls of the same size, density, kind and inertia ratio.
struct Species {
  double radius = 0, density = 0, mass = 0, inertia = 0;
  std::int32_t kind = 0;
  double inertia_ratio = 0;  ///< [1] inertia / (mass radius^2)
};

/// All species, and the law's coefficients for every pair of them.
class SpeciesPairs {
 public:
  SpeciesPairs(const std::vector<scene::Ball>& balls, const contact::PairTable& pairs,
               const contact::AnyLaw& law);

  std::int32_t species_index(std::size_t ball) const { return species_index_[ball]; }
  const Species& species(std::int32_t s) const { return species_[static_cast<std::size_t>(s)]; }
  const Species& species_of(std::size_t ball) const { return species(species_index_[ball]); }
  std::int32_t ball_pair_index(std::int32_t a, std::int32_t b) const { return a * row_length_ + b; }
  std::int32_t wall_pair_index(std::int32_t s, int face) const {
    return s * row_length_ + static_cast<std::int32_t>(species_.size()) + face;
  }
  const SpeciesPair& operator[](std::int32_t pair) const {
    return pairs_[static_cast<std::size_t>(pair)];
  }
  std::span<const SpeciesPair> all() const { return pairs_; }
  std::size_t row_length() const { return static_cast<std::size_t>(row_length_); }
  std::span<const Species> all_species() const { return species_; }

 private:
  std::vector<Species> species_;
  std::vector<std::int32_t> species_index_;  // species of each ball
  std::vector<SpeciesPair> pairs_;
  std::int32_t row_length_ = 0;
};

/// Size classes of species, octaves of the radius above the smallest, the finest first; at most
/// `most`. Classes without a species are left out.
struct SizeClasses {
  SizeClasses(std::span<const Species> species, int most);

  std::vector<std::int32_t> of;  ///< class of each species
  std::vector<double> radius;    ///< [m] of the largest ball of each class
  double smallest = 0;           ///< [m] of all
};

}  // namespace mahlwerk::soft
