// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/kernel/contact_packet.hpp"
#include "mahlwerk/soft/species_pairs.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// What a ball and a curved wall make of a law (dem.4).
struct Bent {
  contact::LawNumbers numbers{};
  double rolling = 0, roll_spring = 0;
};

/// R* of a ball whose centre is at `position`, from both principal curvatures of the face.
Bent bent_wall(const MovingWall& jar, int face, const Vec3& position, double t, double radius,
               const SpeciesPair& pair, const contact::AnyLaw& law);

/// A contact that outlives its collision five times has come to last.
bool outlasts(double duration, const Beginning& began, const SpeciesPair& pair,
              const contact::AnyLaw& law);

}  // namespace mahlwerk::soft
