// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/energy_balance.hpp"
#include "mahlwerk/soft/energy_watch.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"
#include "mahlwerk/soft/kernel/contact_state.hpp"
#include "mahlwerk/soft/rest_watch.hpp"

namespace mahlwerk::soft {

/// The state of a run of many balls without the lists of a solver: what ManyBodySolver and
/// DeviceSolver hand to each other, so that either continues a checkpoint of the other. The bits
/// that follow differ, because each adds the forces on a ball in an order of its own.
struct SolverState {
  /// A contact between ball `i` and ball `j`, or face ~j; histories as seen from i.
  struct Contact {
    std::int32_t i = 0, j = 0;
    ContactState state;
    OptionalState optional;
    FrictionState friction;
    Vec3 normal;  ///< at a wall, at the last step
  };

  std::int64_t step = 0, rested_steps = 0;
  double target_time = 0;             ///< [s] of the last advance()
  std::vector<BallRecord> rows;       ///< by ball, one step ahead, with predicted velocities
  std::vector<SpinRecord> spins;      ///< likewise
  std::vector<VectorPair> half_step;  ///< velocity and spin half a step before that
  std::vector<Contact> contacts;
  scene::EnergyBalance energy_balance;  ///< sums since the start
  EnergyWatch watch;
  RestWatch rest;

  /// An archive of DeviceSolver begins with this number, which is no number of a step.
  static constexpr std::int64_t mark = -46;

  /// What is said where one of the two solvers is that of few balls, which has no such state.
  static constexpr const char* of_few_balls =
      "a state of so few balls does not go from a graphics card to the processor, or back";

  void serialize(Archive& archive) {
    archive(step)(rested_steps)(
        target_time)(rows)(spins)(half_step)(contacts)(energy_balance)(watch);
    rest.serialize(archive);
  }
};

}  // namespace mahlwerk::soft
