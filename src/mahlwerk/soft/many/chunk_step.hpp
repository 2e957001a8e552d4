// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/soft/many/chunk.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

struct ChunkStep;
/// Where the forces of a packet find the bodies of its lanes: their own rows, or those of the
/// spheres in ContactSpheres.
struct PacketRows {
  const BallRecord* rows = nullptr;
  const SpinRecord* spins = nullptr;
  const LaneBodies *i = nullptr, *j = nullptr;
};

/// Force and torque on each ball of a chunk.
using BallForces = std::vector<VectorPair>;

/// Callbacks for contacts of a chunk that begin and end: rare events, outside the innermost loop.
class ManyContactCallbacks {
 public:
  virtual ~ManyContactCallbacks() = default;
  /// Contacts of `list.packets[g]` begin, in the lanes ContactPacket::begun.
  virtual void begin(Chunk& chunk, ContactPackets& list, std::size_t g) = 0;
  /// The speeds of first touch of `begun` (bits of lanes), before their first force.
  virtual void record_onset(ContactPackets& list, std::size_t g, std::uint32_t begun,
                            const OnsetSpeeds& speeds) = 0;
  /// Contacts of `list.packets[g]` end: the lanes of `ended` (bits).
  virtual void end(Chunk& chunk, ContactPackets& list, std::size_t g, std::uint32_t ended) = 0;
  /// Finds the spheres that touch in the lanes of `list.packets[g]`: chunk.spheres.
  virtual void place_contact_spheres(Chunk& chunk, ContactPackets& list, std::size_t g) = 0;
  /// Assigns a lane to a pair that begins to touch.
  virtual void activate(Chunk& chunk, const NeighbourPair& pair) = 0;
  /// Tests wall pairs, and assigns a lane to those that begin to touch.
  virtual void test_walls(Chunk& chunk) = 0;
  /// Adds a force at the wall to the loads of the jar and its parts.
  virtual void add_wall_load(const ChunkStep& step, Chunk& chunk,
                             const MovingWall::WallForce& force) = 0;
  /// Moves the bodies of a chunk over a step, with the forces on their rows.
  virtual void step_bodies(const ChunkStep& step, const Chunk& chunk, const BallForces& forces,
                           ChunkDisplacement& displacement) = 0;
  /// Adds the forces of the liquid to those on the balls of a chunk.
  virtual void add_liquid_forces(const ChunkStep& step, Chunk& chunk, BallForces& forces) = 0;
};

/// Input and output of a step of one chunk. Rows are those of all balls.
struct alignas(64) ChunkStep {
  const BallRecord* rows = nullptr;
  const SpinRecord* spins = nullptr;
  BallRecord* next_rows = nullptr;  ///< rows of the next step
  SpinRecord* next_spins = nullptr;
  /// [m/s], [rad/s] velocity and spin half a step before this step; the step advances them to half
  /// a step after it.
  VectorPair* half_step = nullptr;
  /// Positions when the pairs were last binned.
  const FloatPosition* reference_positions = nullptr;
  /// [s/kg], [s/(kg m2)] half a step over mass and inertia, by species
  const Lanes* half_kick_factors = nullptr;
  const std::int32_t* species = nullptr;
  const PairParameters* parameters = nullptr;  ///< of each species pair, the same in all lanes
  const MovingWall* jar = nullptr;
  ManyContactCallbacks* callbacks = nullptr;
  double time = 0;                ///< [s] the mill's clock
  WallAxes wall_axes;             ///< at this step
  double bin = 0;                 ///< [m] width of the bins of the Verlet list
  double pull_off_distance = 0;   ///< [m] largest of all pairs
  DriveSample drive, next_drive;  ///< at this step and at the next
  bool large = false;             ///< the balls exceed the processor's cache
  bool turning = false;           ///< the jar has a rotor or parts
  bool liquid = false;            ///< there is a liquid
  bool loads = false;             ///< callbacks->add_wall_load() is called for each wall contact
  const std::int32_t* body_of = nullptr;  ///< body of each row, < 0: none; null: all are spheres
  bool rounded = false;                   ///< some bodies are rounded: ContactSpheres
  bool has_history = false;               ///< the law or rolling model needs OptionalHistory
  bool stresses = false;                  ///< grains break: contacts have a StressHistory
  double stored_share = 0;                ///< [1] elastic energy over force and overlap (bed.1)
  StepConstants constants;
};

/// Computes a step of one chunk and updates `displacement`. Meanwhile prefetches the memory of the
/// chunk `following`, if not null.
using ChunkStepper = void (*)(ChunkStep&, Chunk&, const Chunk* following, BallForces&,
                              ChunkDisplacement& displacement);

/// The step function of a law, compiled for the instruction set of this machine.
template <class Law>
ChunkStepper chunk_stepper();

}  // namespace mahlwerk::soft
