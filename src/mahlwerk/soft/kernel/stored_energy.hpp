// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/soft/kernel/contact_data.hpp"

namespace mahlwerk::soft {

/// Energy [J] that a contact stores.
struct StoredEnergy {
  double normal = 0, tangential = 0, twisting = 0;

  double total() const { return normal + tangential + twisting; }
  void add(const StoredEnergy& other, double weight) {
    normal += weight * other.normal;
    tangential += weight * other.tangential, twisting += weight * other.twisting;
  }
};
/// Whether a ball has left the face of an open contact across an edge: it is farther from it than
/// any contact reaches. Its contact ends in this step.
inline bool has_left_face(const PairParameters& parameters, std::size_t lane, double overlap) {
  return overlap < -std::max(parameters.radius_i[lane], 1.01 * parameters.pull_off_distance[lane]);
}

/// What the springs of a contact store, at most as much as friction can hold.
template <class Law>
inline StoredEnergy stored_energy(const Law& law, const PairParameters& parameters,
                                  std::size_t lane, double overlap, const double* law_history,
                                  const Vec3& spring, double twist, bool partial_slip) {
  const contact::LawCoefficients coefficients = coefficients_of(parameters, lane);
  double history[contact::law_history_size];
  for (int n = 0; n < contact::law_history_size; ++n) history[n] = law_history[n];
  const double pressed = std::max(overlap, 0.0);
  StoredEnergy energy{law.elastic_energy(coefficients, history, overlap), 0, 0};
  const auto force = Law::evaluate(coefficients.data(), history, pressed, 0.0);
  const double stiffness = force.stiffness;
  if (!(stiffness > 0)) return energy;
  const double most = parameters.friction[lane] * std::abs(force.load) / stiffness;  // [m]
  const double length = norm(spring) / (partial_slip ? stiffness : 1);
  const double held = std::min(length, most);
  energy.tangential = 0.5 * stiffness * held * held;
  const double square = parameters.twisting_radius[lane] * pressed;  // a^2 (dem.42)
  const double turned = std::min(std::abs(twist) * std::sqrt(square), 4.0 / 3 * most);
  energy.twisting = 0.25 * stiffness * turned * turned;
  return energy;
}

}  // namespace mahlwerk::soft
