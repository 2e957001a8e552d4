// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/body_species.hpp"
#include "mahlwerk/soft/many/chunk_step.hpp"
#include "mahlwerk/soft/many/rigid_bodies.hpp"

namespace mahlwerk::soft {

/// Factors of the motion of a body species.
struct BodyFactors {
  VectorPair half_kick;        ///< [s/kg] half a step over the mass; [s] half a step
  VectorPair inverse_inertia;  ///< [1/(kg m2)] principal, in the first three numbers
};

std::vector<BodyFactors> body_factors(const BodySpeciesTable& species, double time_step);

/// Input and output of a step of the bodies of a chunk.
struct BodyStep {
  const ChunkStep& step;
  const BodySpeciesTable& species;
  const std::vector<BodyFactors>& factors;  ///< by species
  RigidBodies& bodies;
  std::size_t first, last;   ///< bodies
  const VectorPair* forces;  ///< on the rows from that of the first body on
};
/// Velocity Verlet (dem.26) for the centres of mass; for the rotation a leapfrog of the angular
/// momentum (bod.8).
using BodyStepper = void (*)(const BodyStep&, ChunkDisplacement&);
/// Compiled for the instruction set of this machine.
BodyStepper body_stepper();

}  // namespace mahlwerk::soft
