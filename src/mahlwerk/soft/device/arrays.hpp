// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/soft/device/atomics.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"
#include "mahlwerk/soft/kernel/contact_state.hpp"
#include "mahlwerk/soft/kernel/step_data.hpp"
#include "mahlwerk/soft/walls/drive_sample.hpp"

// The state of a run as plain arrays, which kernels read and write: on a graphics card, or in the
// memory of the host (docs/theory/soft.md). Everything here is trivially copyable. Rows are balls
// in the order of their cells.
namespace mahlwerk::soft {

/// Whether a listed pair touches; `ended`: not any more in this step, whose force is the last.
enum class Touch : std::uint8_t { apart, touching, ended };

/// Work of a pair since its sums were collected [J], and its largest overlap over min_radius().
struct ContactSums {
  double normal = 0, tangential = 0, rolling = 0, sliding = 0, wall = 0, max_overlap = 0;

  void add(const ContactSums& more) {
    normal += more.normal, tangential += more.tangential, rolling += more.rolling;
    sliding += more.sliding, wall += more.wall;
    max_overlap = max(max_overlap, more.max_overlap);
  }
};
/// Force [N] on the first body, its negative on the second; torques [N m] on both.
struct PairForce {
  Vec<double> force, torque_i, torque_j;
};

/// Listed pairs, those of balls first, then those of balls and faces: in the order of the first
/// ball.
struct ContactList {
  std::int32_t pairs = 0, walls = 0;
  std::int32_t* pair_first = nullptr;       ///< of each ball, and the end: first pair
  std::int32_t* wall_first = nullptr;       ///< likewise, counted from `pairs`
  std::int32_t *i = nullptr, *j = nullptr;  ///< rows; at a wall, j is the face
  Touch* touch = nullptr;
  ContactState* state = nullptr;
  OptionalState* optional = nullptr;  ///< null where no contact needs it
  FrictionState* friction = nullptr;  ///< likewise
  Vec3* normals = nullptr;            ///< of wall pairs, at their last step in contact

  std::int32_t size() const { return pairs + walls; }
};

/// Arrays of one element for each ball.
struct BallArrays {
  BallRecord* rows = nullptr;       ///< position, radius, predicted velocity (dem.26)
  SpinRecord* spins = nullptr;      ///< predicted
  VectorPair* half_step = nullptr;  ///< velocity and spin half a step before that
  std::int32_t *species = nullptr, *id = nullptr;
};

/// Cells of the balls of one size class: at least as wide as their diameter and the skin, so that
/// a ball of this class or a finer one touches balls in 27 cells at most.
struct CellGrid {
  Vec3 low, inverse_size;   ///< [m], [1/m]
  std::int32_t count[3]{};  ///< number of cells along each axis
  bool wrapped[3]{};        ///< periodic along the axis
  std::int32_t first = 0;   ///< number of the first cell
  std::int32_t cells() const { return count[0] * count[1] * count[2]; }
};

/// What the drive gives to one step.
struct StepInput {
  DriveSample drive;
  WallAxes axes;
};

/// A contact that has ended: what its collision record needs.
struct EndedContact {
  std::int64_t step = 0, onset_step = 0;
  std::int32_t index = 0;            ///< of the pair in its list
  std::int32_t ball = 0, other = 0;  ///< ids; other < 0: face ~other
  std::int32_t species_pair = 0;
  Vec3 position, separation;  ///< [m] of the ball; towards the other body, of any length
  double radius = 0;          ///< [m] of the ball
  double approach = 0, slip = 0, glide = 0, impulse = 0, lost_normal = 0, lost_tangential = 0;
};

/// What sums over the present state need (EnergyBalance).
struct StateSums {
  Vec3 kick_change;  ///< [m/s] half a step times the change of the body acceleration
  Vec3 frame_velocity, frame_centre;  ///< [m/s], [m] of the jar
  Vec3 gravity;                       ///< [m/s2]
};

/// Words by which kernels and host tell each other what happened.
struct Control {
  std::int64_t step = 0;     ///< that kernels compute, or build lists for
  std::int64_t halt_at = 0;  ///< the first step that must not be computed
  std::int64_t ended = 0;    ///< number of ended contacts
  std::int32_t moved = 0;    ///< whether balls have left the range of the lists
  static constexpr std::int32_t no_ball = INT32_MAX;
  std::int32_t bad_ball = no_ball;  ///< lowest id of a ball that is not inside the jar
};

/// Everything that kernels use. Pointers are those of the device.
struct DeviceArrays {
  static constexpr int most_classes = 8;
  static constexpr std::int32_t most_partials = 16384;
  static constexpr std::int32_t contact_counters = 4096;
  static constexpr std::size_t most_model_bytes = 128;

  std::int32_t balls = 0;
  std::int32_t partials = 0;               ///< number of partial sums of a reduction
  BallArrays now, sorted;                  ///< `sorted`: the target of a sort
  Vec3* reference = nullptr;               ///< positions when the lists were built
  ContactList list, old_list;              ///< `old_list`: during a rebuild
  Vec3* wall_points = nullptr;             ///< [m] of each wall pair
  PairForce* forces = nullptr;             ///< of each listed pair
  ContactSums* sums = nullptr;             ///< of each listed pair, since they were collected
  std::int32_t* incoming_first = nullptr;  ///< pairs whose second ball is this one
  std::int32_t* incoming = nullptr;

  std::int32_t *cell = nullptr, *order = nullptr;         ///< of each ball; rows before a sort
  std::int32_t *cell_first = nullptr, *cursor = nullptr;  ///< of each cell; scratch
  std::int32_t* scanned = nullptr;                        ///< what scan kernels sum, in place
  std::int32_t scan_count = 0;
  std::int32_t* scan_partials = nullptr;
  double* partial = nullptr;                 ///< results of reductions
  std::int32_t* balls_in_contact = nullptr;  ///< counters: balls with contacts, over the steps

  EndedContact* ended = nullptr;
  std::int64_t most_ended = 0;  ///< room for ended contacts
  Control* control = nullptr;

  const StepInput* inputs = nullptr;  ///< from step `first_input` on
  std::int64_t first_input = 0;
  const PairParameters* parameters = nullptr;  ///< of each species pair, the same in all lanes
  const double* separation_energy = nullptr;   ///< [J] likewise
  const VectorPair* half_kicks = nullptr;      ///< of each species: half a step over mass, inertia
  const std::int32_t* size_class = nullptr;    ///< of each species
  const double* mass = nullptr;                ///< [kg] of each species
  const double* inertia = nullptr;             ///< [kg m2] of each species
  std::int32_t species_row = 0;                ///< species pairs of one species
  std::int32_t species = 0;
  std::int32_t faces = 0, first_rotor_face = 0;
  double skin = 0, pull_off_distance = 0;  ///< [m]
  CellGrid grid[most_classes];
  double class_radius[most_classes]{};  ///< [m] of the largest ball
  int classes = 0;
  StepConstants constants;
  StateSums state_sums;
  alignas(16) unsigned char law[most_model_bytes]{};    ///< the contact law
  alignas(16) unsigned char shape[most_model_bytes]{};  ///< the shape of the jar

  bool halted() const { return control->step >= shared_word(control->halt_at); }
  const StepInput& input() const { return inputs[control->step - first_input]; }
};

}  // namespace mahlwerk::soft
