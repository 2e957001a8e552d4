// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/many/chunk.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// Contacts of a chunk that begin and end, seldom enough to stand outside the innermost loop.
class ContactEvents {
 public:
  virtual ~ContactEvents() = default;
  /// Lanes of `packets[g]` that touch for the first time.
  virtual void begin(Chunk& chunk, ContactPackets& list, std::size_t g, const ContactGeometry& m,
                     const PairMotion& b) = 0;
  /// Lanes that touched, and do not now.
  virtual void end(Chunk& chunk, ContactPackets& list, std::size_t g, const LaneMask& touching) = 0;
  /// Two balls that touch for the first time get a lane.
  virtual void activate(Chunk& chunk, const NeighbourPair& pair) = 0;
  /// So do balls that touch a wall.
  virtual void test_walls(Chunk& chunk) = 0;
};

/// Everything a step of one chunk needs. Rows are those of all balls.
struct alignas(64) ChunkStep {
  const BallRecord* rows = nullptr;
  const SpinRecord* spins = nullptr;
  BallRecord* next = nullptr;  ///< a step later
  SpinRecord* next_spins = nullptr;
  VectorPair* half = nullptr;                     ///< velocity and spin half a step back
  const FloatPosition* list_positions = nullptr;  ///< at which the neighbour list was built
  const AlignedLanes* kicks =
      nullptr;  ///< [s/kg], [s/(kg m2)] half a step over mass and inertia, by species
  const std::int32_t* species = nullptr;
  const PairParameters* parameters = nullptr;  ///< of each species pair, eight alike
  const MovingWall* jar = nullptr;
  ContactEvents* events = nullptr;
  double time = 0;               ///< [s] the mill's clock
  double bin = 0;                ///< [m] width of the bins of the Verlet list
  double pull_off_distance = 0;  ///< [m] farthest that a contact holds beyond touch
  DriveSample before, after;     ///< now, and a step later
  bool large = false;            ///< more than the processor's cache holds
  bool turning = false;          ///< some faces turn by themselves
  bool has_history = false;      ///< laws or rolling that need OptionalHistory
  StepConstants constants;
};

/// Force and torque on each ball of a chunk.
using BallForces = std::vector<VectorPair>;

/// A step of one chunk; sets how its balls have moved, where `displacement` guessed their mean. The
/// memory of the one `following`, if any, is fetched meanwhile.
using ChunkStepper = void (*)(ChunkStep&, Chunk&, const Chunk* following, BallForces&,
                              ChunkDisplacement& displacement);

/// The step of each law, compiled for this machine.
template <class Law>
ChunkStepper chunk_stepper();

}  // namespace mahlwerk::soft
