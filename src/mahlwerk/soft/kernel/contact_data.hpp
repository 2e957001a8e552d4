// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>

#include "mahlwerk/contact/law.hpp"
#include "mahlwerk/soft/kernel/body_blocks.hpp"

namespace mahlwerk::soft {

/// Impulse and work of a contact since its onset: sums over steps of force or power times the step.
struct alignas(64) ContactWork {
  Lanes impulse{};      ///< [N s] normal
  Lanes normal{};       ///< [J] dissipated along the normal (dem.39)
  Lanes tangential{};   ///< [J] work done against friction
  Lanes rolling{};      ///< [J] work done against rolling resistance
  Lanes sliding{};      ///< [J] part of `tangential`: sliding at the Coulomb limit
  Lanes wall{};         ///< [J] work done by the wall, in the laboratory frame
  Lanes max_overlap{};  ///< [m] largest overlap; ChunkSums::work holds it over min_radius() [1]
};

/// Onset of a contact: step and speeds of first touch.
struct ContactOnset {
  std::int64_t step = 0;
  double approach = 0, slip = 0, glide = 0;  ///< [m/s]
};
/// Speeds of first touch of the contacts of a packet.
struct OnsetSpeeds {
  Lanes approach{}, slip{}, glide{};  ///< [m/s] approach < 0 where the bodies already separate
};

/// Parameters of eight pairs of bodies i and j. Body j is a ball or a wall contact point, which is
/// treated as a ball of radius 0.
struct alignas(64) PairParameters {
  LaneMask wall{};               ///< where j is a wall point
  Lanes radius_i{}, radius_j{};  ///< [m] 0 for a wall point
  Lanes inverse_radius{};        ///< [1/m] 1 / min_radius()
  Lanes overlap_share{};         ///< fraction of the overlap in i: 0.5, or 1 at a wall
  Lanes pull_off_distance{};     ///< [m] gap at which a contact breaks
  Lanes coefficients[contact::law_coefficient_count]{};
  Lanes friction{};             ///< mu
  Lanes twisting_radius{};      ///< [m] R* (dem.42)
  Lanes rolling_coefficient{};  ///< [m] mu_r R*; [s] for viscous; mu_r for own_spin
  /// [m2] rolling over tangential stiffness, for epsd: the elastic-plastic spring-dashpot rolling
  /// model.
  Lanes rolling_stiffness_ratio{};
  Lanes inertia{};                      ///< [kg m2] reduced moment of inertia
  Lanes slip_factor{};                  ///< [1] of the pair (hol.4)
  Lanes phase_squared_per_stiffness{};  ///< [m/N] of SpeciesPair (dem.37)
  Lanes half_step_squared_over_mass{};  ///< [s2/kg] dt^2/(2 m*)
};

/// Radius [m] of the smaller ball; that of the ball at a wall. Overlaps are stated in it.
inline double min_radius(const PairParameters& p, std::size_t lane) {
  return p.wall[lane] != 0 ? p.radius_i[lane] : std::min(p.radius_i[lane], p.radius_j[lane]);
}

inline contact::LawCoefficients coefficients_of(const PairParameters& p, std::size_t lane) {
  contact::LawCoefficients coefficients;
  for (std::size_t n = 0; n < coefficients.size(); ++n) coefficients[n] = p.coefficients[n][lane];
  return coefficients;
}
inline void copy_lane(const PairParameters& a, std::size_t lane, PairParameters& b,
                      std::size_t other_lane) {
  constexpr std::size_t columns = sizeof(PairParameters) / sizeof(Lanes);
  using Number = double __attribute__((may_alias));  // masks are copied as bits
  const auto* from = reinterpret_cast<const Number*>(&a);
  auto* to = reinterpret_cast<Number*>(&b);
  for (std::size_t c = 0; c < columns; ++c) to[c * lanes + other_lane] = from[c * lanes + lane];
}

/// History of the contacts of a group, in registers.
template <class V>
struct GroupHistory {
  V law_history[contact::law_history_size]{};
  Vec<V> spring{}, rolling_spring_torque{};
  V stiffness{};
  MaskOf<V> tensile{};
  Vec<V> turning_force{};  ///< see FrictionHistory
  V load{}, twist{};
};

/// History of eight contacts that only partial slip and twisting friction need.
struct alignas(64) FrictionHistory {
  Vec<Lanes> turning_force{};  ///< [N] tangential force where its loading last turned round
  Lanes load{};                ///< [N] at the last step
  Lanes twist{};               ///< [rad] angle of the twisting spring, half a step ahead
};

inline void clear_friction_history(FrictionHistory& history, std::size_t lane) {
  set_lane(history.turning_force, lane, {});
  history.load[lane] = history.twist[lane] = 0;
}

/// History of eight contacts.
struct alignas(64) History : FrictionHistory {
  Lanes law_history[contact::law_history_size]{};
  /// [m] tangential spring xi, half a step ahead; with partial slip its force [N]
  Vec<Lanes> spring{};
  Vec<Lanes> rolling_spring_torque{};  ///< [N m] epsd: torque of the rolling spring
  Lanes stiffness{};                   ///< [N/m] tangential, at the last step
  LaneMask tensile{};                  ///< lanes with a load < 0 at the last step
};

}  // namespace mahlwerk::soft
