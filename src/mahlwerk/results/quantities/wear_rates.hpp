// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/results/outcome.hpp"

// Wear rates of the bodies of a case with [wear], in one replicate.
namespace mahlwerk::results {

/// [m3/s] Wear of the balls of one set. Grains are powder and do not wear.
double set_wear_rate(const cases::Case& c, const Replicate& r, int set);
/// [m3/s] Wear of one distinguished face: of the jar, or a part.
double face_wear_rate(const cases::Case& c, const Replicate& r, int face);
/// [kg/s] Wear of all distinguished faces from `first` to before `end`.
double faces_wear(const cases::Case& c, const Replicate& r, int first, int end);
double balls_wear(const cases::Case& c, const Replicate& r);  ///< [kg/s]
double jar_wear(const cases::Case& c, const Replicate& r);    ///< [kg/s]
double parts_wear(const cases::Case& c, const Replicate& r);  ///< [kg/s]

/// What wears at a distinguished face: the jar or a part.
struct WallMaterial {
  double hardness, density;  ///< Vickers number, [kg/m3]
};
WallMaterial wall_material(const cases::Case& c, const Replicate& r, int face);

}  // namespace mahlwerk::results
