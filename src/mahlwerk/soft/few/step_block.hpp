// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <vector>

#include "mahlwerk/soft/few/particle_data.hpp"

// A block of steps: what the innermost loop (step_loop.hpp) reads, writes and calls.
namespace mahlwerk::soft {

/// Lanes of a packet.
struct PacketLanes {
  std::size_t packet = 0;
  std::uint32_t bits = 0;
};

template <class F>
void each_lane(const PacketLanes& some, const F& f) {
  for (std::size_t l = 0; l < lanes; ++l)
    if ((some.bits >> l & 1) != 0) f(l);
}

/// Callbacks for rare events, outside the innermost loop. Packets are numbered as in StepBlock.
class StepCallbacks {
 public:
  virtual ~StepCallbacks() = default;
  /// Rebuilds the neighbour list of a charge: a displacement exceeded half the skin. Returns false
  /// if the charge failed and was taken out of the block.
  virtual bool rebuild_neighbour_list(std::size_t charge) = 0;
  /// Contacts begin.
  virtual void begin(const PacketLanes& begun) = 0;
  /// The speeds of first touch, before the first force.
  virtual void record_onset(const PacketLanes& begun, const OnsetSpeeds& speeds) = 0;
  /// Contacts end in this step; their last force is yet to be computed.
  virtual void end(const PacketLanes& ended) = 0;
  /// Adds a force at the wall to the loads of the jar and its parts.
  virtual void add_wall_load(const DriveSample& /*drive*/, const MovingWall::WallForce&) {}
  /// After the forces of a step in which contacts ended.
  virtual void forces_done() = 0;
  /// Adds the forces of the liquid to the balls of a charge, after those of the contacts.
  virtual void add_liquid_forces(std::size_t charge, const DriveSample& drive) = 0;
  /// After a step in which a charge was idle (ParticleData::idle_from), or step StepBlock::pause.
  /// Returns whether the block goes on.
  virtual bool pause() = 0;
};

/// Everything a block of steps needs. Callbacks may change the charges and packets.
struct alignas(64) StepBlock {
  std::vector<ParticleData*>& charges;  ///< which step together, all at the same step
  std::vector<PairPacket>& packets;     ///< of all charges
  std::vector<GatherMap>& gather_maps;
  bool shared = false;  ///< packets are shared by charges: they are not those of charges[0]
  const MovingWall& jar;
  StepCallbacks& callbacks;
  StepConstants constants;
  std::span<const DriveSample> drive;  ///< samples: one more than steps
  double start = 0;                    ///< [s] the mill's clock at step 0
  double max_displacement = 0;         ///< [m] a larger one rebuilds the neighbour list
  std::int64_t step = 0;               ///< step of the charges
  bool loads = false;                  ///< callbacks.add_wall_load() is called in each step
  bool liquid = false;                 ///< callbacks.add_liquid_forces() is called in each step
  std::int64_t pause = -1;             ///< step after which callbacks.pause() is called
};

/// Computes a block of steps.
using BlockStepper = void (*)(StepBlock&);

/// The step function of a law, compiled for the instruction set of this machine.
template <class Law>
BlockStepper block_stepper();

}  // namespace mahlwerk::soft
