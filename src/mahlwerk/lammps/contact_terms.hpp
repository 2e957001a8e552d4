// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/contact/law.hpp"

namespace mahlwerk::lammps {

/// The restitution that `damping tsuji` must be given for the damping coefficient `alpha` [1], from
/// 0 to 2.24 (lmp.1). LAMMPS turns its input into alpha by a polynomial that is off by up to 0.14
/// in e; this is its inverse, which is below 0 for small e.
double tsuji_input(double alpha);

/// The coefficients of a pair for `pair_style granular` and `fix wall/gran granular`: normal and
/// tangential model, rolling and damping, with all numbers put in (lmp.2 to lmp.4). The law must be
/// hertz-mindlin or linear-spring.
std::string contact_terms(const contact::ContactModel& model, const contact::EffectivePair& pair);

}  // namespace mahlwerk::lammps
