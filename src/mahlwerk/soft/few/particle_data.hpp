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

/// Force [N] and torque [N m] on a body in a contact.
struct alignas(64) ForceRow {
  double values[8];
};

/// Where the lanes of a packet find their bodies and leave their forces. Derived from PairPacket.
struct alignas(64) GatherMap {
  /// Addresses of position.x of bodies i and j; the other numbers of a body are at constant
  /// distances from there.
  std::array<const double*, lanes> body_i{}, body_j{};
  std::array<ForceRow*, lanes> row_i{}, row_j{};  ///< of the forces on i and j
  std::uint32_t filled = 0;  ///< lanes (bits) whose rows may hold numbers other than 0
  /// If `fits_registers`: for ball l of up to eight, the force of its k-th contact is that on body
  /// i of lane source[k][l], or, if source[k][l] >= lanes, that on body j of lane source[k][l] -
  /// lanes. active[k] masks the balls that have a k-th contact.
  std::array<LaneMask, lanes> source{}, active{};
  int max_contacts = 0;  ///< largest number of contacts of one ball
};

/// State of all bodies and contacts of a charge. Bodies are the balls, padded to whole blocks,
/// followed by the wall points (MovingWall::wall_points).
struct ParticleData {
  std::int64_t step = 0;
  std::size_t count = 0;          ///< of balls
  std::vector<BodyBlock> bodies;  ///< blocks of balls, then of wall points
  std::vector<BallBlock> balls;
  std::vector<PairPacket> packets;
  std::vector<GatherMap> gather_maps;  ///< of each packet
  /// Two rows for each lane, the force on i and that on j, in the order of the packets; then one
  /// row for the forces on walls and in free lanes.
  std::vector<ForceRow> force_rows;
  /// The force rows of each ball, in the order of their lanes, one ball after the other: number of
  /// rows of each, and their distances [bytes] from the first element of `force_rows`.
  std::vector<std::uint16_t> rows_of_ball;
  std::vector<std::uint32_t> row_offsets;
  std::vector<WallNeighbour> wall_neighbours;    ///< wall point k belongs to wall_neighbours[k]
  std::vector<WallPointLanes> wall_point_lanes;  ///< of wall_neighbours
  /// Of wall_neighbours, where the wall keeps them. They change no result and are not saved.
  std::vector<geometry::NearFacets> near_facets;
  bool fits_registers = false;  ///< each column of all bodies fits in two registers of eight
  bool wall_points_due = true;  ///< update every wall point at the next step
  std::int64_t list_step = 0;   ///< when the neighbour list was built
  std::int64_t idle_from = 0;   ///< from this step on, a step without contacts ends the block
  std::int64_t contacts = 0;    ///< that exist
  bool touched = true;          ///< contacts existed in the last step

  Vec3 position(std::size_t body) const {
    return get_lane(bodies[body / lanes].position, body % lanes);
  }
  Vec3 velocity(std::size_t ball) const {
    return get_lane(balls[ball / lanes].velocity, ball % lanes);
  }
  Vec3 spin(std::size_t ball) const { return get_lane(balls[ball / lanes].spin, ball % lanes); }
};

}  // namespace mahlwerk::soft
