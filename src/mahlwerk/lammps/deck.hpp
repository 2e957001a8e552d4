// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/contact/law.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"

// A case as input files of LAMMPS, which runs as a program of its own (docs/theory/lammps.md).
namespace mahlwerk::lammps {

/// Time stepping of a run, and how often LAMMPS writes. All are numbers of steps.
struct Steps {
  double time_step = 0;      ///< [s]
  std::int64_t power = 1;    ///< between two samples of the power
  std::int64_t row = 1;      ///< between two lines of the balance, and of contacts that ended
  std::int64_t frame = 1;    ///< between two frames of all balls
  std::int64_t wall = 1;     ///< between two looks for new contacts with the jar
  std::int64_t restart = 1;  ///< between two restart files
  std::int64_t total = 0;    ///< to the next frame after `time`
  double time = 0;           ///< [s] that is asked for

  /// Whether frames are frequent enough to show contacts with the jar.
  bool frames_show_wall() const { return frame <= wall; }
  double frame_time() const { return static_cast<double>(frame) * time_step; }  // [s]
};

/// Steps of a run of `time` [s] of `balls` balls in steps of `time_step` [s], of which `counted`
/// [s] count. `contact` [s] is the shortest collision.
Steps steps_of(const cases::Case& mill_case, double time, double counted, double time_step,
               double contact);

/// Why LAMMPS cannot run the case; empty if it can. Each fault lists what it can.
std::vector<Fault> faults(const cases::Case& mill_case);

/// Two balls that may touch, with the properties of their kinds.
contact::EffectivePair pair_of(const contact::Pair& pair, const scene::Ball& a,
                               const scene::Ball& b);

/// The type in LAMMPS of each ball, from 0: one for each ball set and diameter, in the order in
/// which they occur.
std::vector<int> types_of(const std::vector<scene::Ball>& balls);
/// The first ball of each type.
std::vector<scene::Ball> one_of_each_type(const std::vector<scene::Ball>& balls);

/// The input script: `lmp -in in.lammps` begins the run, and with `-var from restart.a -var session
/// 1` goes on with it. `ranks` decides on the domains. The case must have no faults().
std::string script(const cases::Case& mill_case, const scene::Chamber& chamber,
                   const std::vector<scene::Ball>& balls, const Steps& steps, int ranks);
/// The balls at the start, in the jar frame, as a data file.
std::string ball_file(const scene::Chamber& chamber, const std::vector<scene::Ball>& balls);

}  // namespace mahlwerk::lammps
