// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

namespace mahlwerk::soft {

/// 3-vectors of bodies as a structure of arrays, in blocks of eight bodies.
struct VectorColumns {
  std::vector<Lanes> x, y, z;

  void resize(std::size_t blocks) { x.resize(blocks), y.resize(blocks), z.resize(blocks); }
  Vec3 get(std::size_t body) const {
    const std::size_t b = body / lanes, l = body % lanes;
    return {x[b][l], y[b][l], z[b][l]};
  }
  void set(std::size_t body, const Vec3& a) {
    const std::size_t b = body / lanes, l = body % lanes;
    x[b][l] = a.x, y[b][l] = a.y, z[b][l] = a.z;
  }
  /// A register of consecutive bodies from `body` on, a multiple of the register's width.
  template <class V>
  Vec<V> at(std::size_t body) const {
    return {load<V>(&x[0][0] + body), load<V>(&y[0][0] + body), load<V>(&z[0][0] + body)};
  }
  template <class V>
  void put(std::size_t body, const Vec<V>& a) {
    store<V>(&x[0][0] + body, a.x), store<V>(&y[0][0] + body, a.y), store<V>(&z[0][0] + body, a.z);
  }
};

/// One column as an array of doubles.
inline double* column_data(std::vector<Lanes>& column) {
  return column.front().values;
}
inline const double* column_data(const std::vector<Lanes>& column) {
  return column.front().values;
}

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

/// Gather indices of a packet. For ball l of up to eight, the force of its k-th contact is that on
/// body i of lane source[k][l], or, if source[k][l] >= lanes, that on body j of lane
/// source[k][l] - lanes. active[k] masks the balls that have a k-th contact.
struct alignas(64) GatherMap {
  std::array<LaneMask, lanes> source{}, active{};
  int max_contacts = 0;  ///< largest number of contacts of one ball
};

/// State of all bodies and contacts. Bodies are the balls, padded to whole blocks, followed by the
/// wall points (MovingWall::wall_points).
struct ParticleData {
  std::int64_t step = 0;
  std::size_t balls = 0, blocks = 0;  ///< blocks of balls
  VectorColumns position;             ///< [m] of all bodies, in the jar frame
  VectorColumns velocity_predicted,
      spin_predicted;                        ///< [m/s], [rad/s] of all bodies, predicted (dem.26)
  VectorColumns velocity, spin;              ///< of the balls, at the end of the step
  VectorColumns force, torque;               ///< [N], [N m] of the contacts on the balls
  std::vector<Lanes> half_kick_factor;       ///< [s/kg] half a step over mass
  std::vector<Lanes> half_spin_kick_factor;  ///< [s/(kg m2)] half a step over inertia
  std::vector<PairPacket> packets;
  std::vector<GatherMap> gather_maps;          ///< of each packet, if `fits_registers`
  std::vector<WallNeighbour> wall_neighbours;  ///< wall point k belongs to wall_neighbours[k]
  VectorColumns list_positions;                ///< [m] when the neighbour list was built
  std::vector<Lanes> displacement_squared;  ///< [m2] squared displacement of the balls since then
  bool fits_registers = false;              ///< each column of all bodies fits in two registers
  bool wall_points_due = true;              ///< update every wall point at the next step
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
