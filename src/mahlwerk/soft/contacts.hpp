// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/scene/account.hpp"
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
void bend(PairParameters& parameters, int lane, const MovingWall& jar, int face,
          const Vec3& position, double t, const SpeciesPair& pair, const contact::AnyLaw& law);

/// How the contact of a lane begins at `step`.
Beginning beginning(std::int64_t step, const ContactGeometry& m, const Bodies& b, int lane);
/// What the law remembers of a contact that begins.
void begin_memory(Lanes (&memory)[contact::law_memories], const PairParameters& parameters,
                  int lane, double approach, const contact::AnyLaw& law);

/// What the contact of a lane has done, into the energy account.
void add_work(scene::Account& account, const ContactWork& work, int lane);

/// A contact that outlives its collision five times has come to last.
bool outlasts(double duration, const Beginning& began, const SpeciesPair& pair,
              const contact::AnyLaw& law);

/// What is the same for all packets of all steps; the jar's speed changes.
Frame frame_of(const Rules& rules, const Vec3& periods);

}  // namespace mahlwerk::soft
