// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/contact/law.hpp"

namespace mahlwerk::soft {

/// What a contact has done since it began; sums over steps of power times the step.
struct alignas(64) ContactWork {
  Lanes impulse{};     ///< [N s] normal
  Lanes normal{};      ///< [J] work done along the normal
  Lanes tangential{};  ///< [J] across it
  Lanes rolling{};     ///< [J] by rolling resistance
  Lanes sliding{};     ///< [J] of `tangential`, by slip at the Coulomb limit
  Lanes wall{};        ///< [J] work the wall did, in laboratory axes
  Lanes deepest{};     ///< [m] overlap
};

/// How a contact began.
struct ContactOnset {
  std::int64_t step = 0;
  double approach = 0, slip = 0, glide = 0;  ///< [m/s]
};

/// What eight pairs of bodies are made of. A body is a ball, or a wall point, a ball of no
/// size.
struct alignas(64) PairParameters {
  LaneMask wall{};               ///< where j is a wall point
  Lanes radius_i{}, radius_j{};  ///< [m] 0 of a wall point
  Lanes per_radius{};            ///< [1/m] of radius_i
  Lanes share{};                 ///< of the overlap that lies in i: half, or all against a wall
  Lanes pull_off_distance{};     ///< [m] a contact holds beyond touch
  Lanes coefficients[contact::law_coefficient_count]{};
  Lanes friction{};     ///< mu
  Lanes rolling{};      ///< [m] mu_r R*; [s] for the viscous rule
  Lanes roll_spring{};  ///< [m2] epsd: its stiffness over the contact's stiffness across
  Lanes inertia{};      ///< [kg m2] reduced, of two bodies that roll on each other
  Lanes lag{};          ///< [m/N] of the tangential spring (dem.37)
};

inline Vec3 get_lane(const Vec<Lanes>& a, int lane) {
  return {a.x[lane], a.y[lane], a.z[lane]};
}
inline void set_lane(Vec<Lanes>& a, int lane, const Vec3& b) {
  a.x[lane] = b.x, a.y[lane] = b.y, a.z[lane] = b.z;
}
inline contact::LawCoefficients coefficients_of(const PairParameters& p, int lane) {
  contact::LawCoefficients coefficients;
  for (std::size_t n = 0; n < coefficients.size(); ++n) coefficients[n] = p.coefficients[n][lane];
  return coefficients;
}
inline void copy_lane(const PairParameters& a, int lane, PairParameters& b, int other_lane) {
  constexpr std::size_t columns = sizeof(PairParameters) / sizeof(Lanes);
  using Number = double __attribute__((may_alias));  // masks among them are whole numbers
  const auto* from = reinterpret_cast<const Number*>(&a);
  auto* to = reinterpret_cast<Number*>(&b);
  for (std::size_t c = 0; c < columns; ++c)
    to[c * lanes + static_cast<std::size_t>(other_lane)] =
        from[c * lanes + static_cast<std::size_t>(lane)];
}

/// What eight contacts remember from step to step.
struct alignas(64) History {
  Lanes law_history[contact::law_history_size]{};
  Vec<Lanes> spring{};  ///< [m] xi, the tangential spring, half a step ahead
  Vec<Lanes> roll{};    ///< [N m] epsd: its spring's moment
  Lanes stiffness{};    ///< [N/m] across, at the last step
  LaneMask pulls{};     ///< where the bodies pulled each other then
};

}  // namespace mahlwerk::soft
