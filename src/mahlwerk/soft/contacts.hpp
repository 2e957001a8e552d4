// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/scene/energy_balance.hpp"
#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/rules.hpp"
#include "mahlwerk/soft/species_pairs.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// Of a ball `a` and another `b`, or a wall where there is none; eight alike.
PairParameters pair_parameters(const SpeciesPair& pair, const Species& a, const Species* b,
                               double time_step);

/// A contact's law, R* of a ball at `position` taken from both principal curvatures of the face
/// (dem.4).
void apply_wall_curvature(PairParameters& parameters, int lane, const MovingWall& jar, int face,
                          const Vec3& position, double t, const SpeciesPair& pair,
                          const contact::AnyLaw& law);

/// How the contact of a lane begins at `step`.
ContactOnset contact_onset(std::int64_t step, const ContactGeometry& m, const PairMotion& b,
                           int lane);
/// What the law remembers of a contact that begins.
void begin_law_history(Lanes (&law_history)[contact::law_history_size],
                       const PairParameters& parameters, int lane, double approach,
                       const contact::AnyLaw& law);

/// What the contact of a lane has done, into the energy account.
void add_work(scene::EnergyBalance& energy_balance, const ContactWork& work, int lane);

/// A contact that outlives its collision five times has come to last.
bool is_lasting(double duration, const ContactOnset& onset, const SpeciesPair& pair,
                const contact::AnyLaw& law);

/// What is the same for all packets of all steps; the jar's speed changes.
StepConstants step_constants(const Rules& rules, const Vec3& periods);

}  // namespace mahlwerk::soft
