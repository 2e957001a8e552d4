// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// Vectors, a component at a time, eight bodies to a block.
struct VectorColumns {
  std::vector<AlignedLanes> x, y, z;

  void resize(std::size_t blocks) { x.resize(blocks), y.resize(blocks), z.resize(blocks); }
  Vec<Lanes> at(std::size_t block) const {
    return {x[block].value, y[block].value, z[block].value};
  }
  void put(std::size_t block, const Vec<Lanes>& a) {
    x[block].value = a.x, y[block].value = a.y, z[block].value = a.z;
  }
  Vec3 get(std::size_t body) const {
    const std::size_t b = body / lanes, l = body % lanes;
    return {x[b].value[l], y[b].value[l], z[b].value[l]};
  }
  void set(std::size_t body, const Vec3& a) {
    const std::size_t b = body / lanes, l = body % lanes;
    x[b].value[l] = a.x, y[b].value[l] = a.y, z[b].value[l] = a.z;
  }
};

/// One column as plain numbers.
inline double* column_data(std::vector<AlignedLanes>& column) {
  return reinterpret_cast<double*>(column.data());
}
inline const double* column_data(const std::vector<AlignedLanes>& column) {
  return reinterpret_cast<const double*>(column.data());
}

/// Eight neighbour pairs side by side, with the history of those that touch. Free lanes touch
/// nothing. A ContactPacket of many bodies has contacts only, and a sixth of the memory: parameters
/// are those of a species pair, and most of the work is summed over a chunk.
struct alignas(64) PairPacket : PairParameters, History {
  LaneMask i{}, j{};    ///< bodies; i is always a ball
  LaneMask touching{};  ///< since the last step
  Vec<Lanes> normal{};  ///< from i to j, at the last step: what ends may have no normal any more
  ContactWork work;

  std::array<std::int32_t, lanes> face{};          ///< of a wall; < 0: balls
  std::array<std::int32_t, lanes> species_pair{};  ///< which pair of species (SpeciesPairs)
  std::array<bool, lanes> used{};
  std::array<ContactOnset, lanes> onset{};
};

/// Where each of up to eight balls finds its contacts in a packet: the k-th at lane `source[k]`,
/// from `lanes` on with the opposite sign.
struct alignas(64) GatherMap {
  std::array<LaneMask, lanes> source{}, active{};
  int max_contacts = 0;  ///< contacts of one ball
};

/// All bodies and contacts, and how far they have come. Bodies: the balls, up to a whole number of
/// blocks; then the wall points (MovingWall::wall_points).
struct ParticleData {
  std::int64_t step = 0;
  std::size_t balls = 0, blocks = 0;  ///< blocks of balls
  VectorColumns position;             ///< [m] of all bodies, in the jar frame
  VectorColumns velocity_predicted,
      spin_predicted;                        ///< [m/s], [rad/s] of all bodies, predicted (dem.26)
  VectorColumns velocity, spin;              ///< of the balls, at the end of the step
  VectorColumns force, torque;               ///< [N], [N m] of the contacts on the balls
  std::vector<AlignedLanes> half_kick;       ///< [s/kg] half a step over mass
  std::vector<AlignedLanes> half_spin_kick;  ///< [s/(kg m2)] half a step over inertia
  std::vector<PairPacket> packets;
  std::vector<GatherMap> gather_maps;          ///< of each packet, where `fits_registers`
  std::vector<WallNeighbour> wall_neighbours;  ///< wall point k belongs to wall_neighbours[k]
  VectorColumns list_positions;                ///< at which the neighbour list was built
  std::vector<AlignedLanes> displacement_squared;  ///< [m2] the square of how far balls have moved since
  bool fits_registers = false;      ///< all bodies fit into two registers
  bool wall_points_due = true;      ///< every wall point must be found at the next step
};

/// What happens seldom, outside the innermost loop.
class SlowPath {
 public:
  virtual ~SlowPath() = default;
  /// Rebuilds the neighbour list: a displacement exceeded half the skin.
  virtual void rebuild_neighbour_list() = 0;
  /// Contacts of a packet begin.
  virtual void begin(PairPacket& packet, const LaneMask& begun, const ContactGeometry& geometry,
                     const PairMotion& motion) = 0;
  /// Contacts end, after their last push.
  virtual void end(PairPacket& packet, const LaneMask& ended) = 0;
};

/// Everything a block of steps needs.
struct alignas(64) StepBlock {
  ParticleData& particles;
  const MovingWall& jar;
  SlowPath& slow_path;
  StepConstants constants;
  std::span<const DriveSample> drive;  ///< one more than steps
  double start = 0;                    ///< [s] the mill's clock at step 0
  double max_displacement = 0;         ///< [m] a ball may move before the neighbour list is rebuilt
  std::int64_t list_step = 0;          ///< the step at which it was last built
  bool stop_when_idle = false;         ///< stop after a step in which nothing touched
};

/// Takes steps; returns whether anything touched in the last one.
using BlockStepper = bool (*)(StepBlock&);

/// The steps of each law, compiled for this machine.
template <class Law>
BlockStepper block_stepper();

}  // namespace mahlwerk::soft
