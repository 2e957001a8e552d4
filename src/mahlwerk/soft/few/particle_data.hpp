// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// Eight neighbour pairs, with the history of those that touch. Free lanes touch nothing. In
/// contrast, a ContactPacket of ManyBodySolver holds contacts only and takes a sixth of the memory:
/// its parameters are those of a species pair, and most work is summed over a chunk.
struct alignas(64) PairPacket : PairParameters, History {
  LaneMask i{}, j{};    ///< bodies; i is always a ball
  LaneMask touching{};  ///< at the last step
  Vec<Lanes> normal{};  ///< from i to j, at the last step: needed when a contact ends
  ContactWork work;

  std::array<std::int32_t, lanes> face{};          ///< face of a wall; < 0: two balls
  std::array<std::int32_t, lanes> species_pair{};  ///< index in SpeciesPairs
  std::array<bool, lanes> used{};
  std::array<ContactOnset, lanes> onset{};
};

/// Where the bodies of a packet are. Derived from PairPacket.
struct alignas(64) GatherMap {
  /// [bytes] from the first BodyBlock to the numbers of bodies i and j: address of position.x.
  std::array<std::int64_t, lanes> offset_i{}, offset_j{};
  /// Row of ParticleData::force_rows to which the force on j is added; that on i goes to row i.
  std::array<std::int64_t, lanes> row_j{};
  /// If `fits_registers`: for ball l of up to eight, the force of its k-th contact is that on body
  /// i of lane source[k][l], or, if source[k][l] >= lanes, that on body j of lane source[k][l] -
  /// lanes. active[k] masks the balls that have a k-th contact.
  std::array<LaneMask, lanes> source{}, active{};
  int max_contacts = 0;  ///< largest number of contacts of one ball
};

/// Force [N] and torque [N m] on a ball, summed over contacts.
struct alignas(64) ForceRow {
  double values[8];
};

/// State of all bodies and contacts. Bodies are the balls, padded to whole blocks, followed by the
/// wall points (MovingWall::wall_points).
struct ParticleData {
  std::int64_t step = 0;
  std::size_t count = 0;          ///< of balls
  std::vector<BodyBlock> bodies;  ///< blocks of balls, then of wall points
  std::vector<BallBlock> balls;
  std::vector<PairPacket> packets;
  std::vector<GatherMap> gather_maps;          ///< of each packet
  std::vector<ForceRow> force_rows;            ///< of each ball; one more for walls
  std::vector<WallNeighbour> wall_neighbours;  ///< wall point k belongs to wall_neighbours[k]
  bool fits_registers = false;  ///< each column of all bodies fits in two registers of eight
  bool wall_points_due = true;  ///< update every wall point at the next step

  Vec3 position(std::size_t body) const {
    return get_lane(bodies[body / lanes].position, body % lanes);
  }
  Vec3 velocity(std::size_t ball) const {
    return get_lane(balls[ball / lanes].velocity, ball % lanes);
  }
  Vec3 spin(std::size_t ball) const { return get_lane(balls[ball / lanes].spin, ball % lanes); }
};

/// Callbacks for rare events, outside the innermost loop.
class FewContactCallbacks {
 public:
  virtual ~FewContactCallbacks() = default;
  /// Rebuilds the neighbour list: a displacement exceeded half the skin.
  virtual void rebuild_neighbour_list() = 0;
  /// Contacts of a packet begin: lanes of `begun` (bits).
  virtual void begin(PairPacket& packet, std::uint32_t begun) = 0;
  /// The speeds of first touch of `begun`, before their first force.
  virtual void record_onset(PairPacket& packet, std::uint32_t begun, const OnsetSpeeds& speeds) = 0;
  /// Contacts end, after their last force was applied.
  virtual void end(PairPacket& packet, std::uint32_t ended) = 0;
};

/// Everything a batch of steps needs.
struct alignas(64) StepBatch {
  ParticleData& particles;
  const MovingWall& jar;
  FewContactCallbacks& callbacks;
  StepConstants constants;
  std::span<const DriveSample> drive;  ///< samples: one more than steps
  double start = 0;                    ///< [s] the mill's clock at step 0
  double max_displacement = 0;         ///< [m] a larger one rebuilds the neighbour list
  std::int64_t list_step = 0;          ///< step of the last rebuild
  bool stop_when_idle = false;         ///< stop after a step without contacts
};

/// Computes a batch of steps; returns whether the last one had contacts.
using BatchStepper = bool (*)(StepBatch&);

/// The step function of a law, compiled for the instruction set of this machine.
template <class Law>
BatchStepper batch_stepper();

}  // namespace mahlwerk::soft
