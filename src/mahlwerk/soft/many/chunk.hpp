// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/geometry/convex_core.hpp"
#include "mahlwerk/geometry/near_facets.hpp"
#include "mahlwerk/scene/collision.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"
#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/liquid.hpp"
#include "mahlwerk/soft/many/block_list.hpp"
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

namespace mahlwerk::soft {

using LaneBodies = std::array<std::int32_t, lanes>;  ///< a body for each lane

/// Eight contacts. Only touching pairs have a lane. Free lanes touch nothing, but hold indices of
/// existing bodies.
struct alignas(64) ContactPacket {
  LaneBodies i{}, j{};  ///< balls; at a wall, j is the face
  std::array<std::int32_t, lanes> species_pair{};
  std::uint32_t touching = 0, begun = 0;  ///< bits of lanes: in contact; new in this step
  std::uint32_t tensile = 0;              ///< bits of lanes with a load < 0 at the last step
  bool one_species_pair = true;           ///< all lanes have the same species pair
  Vec<Lanes> spring{};
  Lanes impulse{}, lost_normal{}, lost_tangential{};  ///< since the onset

  bool touches(std::size_t lane) const { return (touching & bit(lane)) != 0; }
};
/// History variables that only some laws and rolling models need.
struct alignas(64) OptionalHistory {
  Lanes law_history[contact::law_history_size]{};
  Vec<Lanes> rolling_spring_torque{};
  Lanes stiffness{};  ///< for ContactModel::rescaled_unloading
};

/// The normals of wall contacts at the last step, for records: when a contact ends, the ball may
/// already have left the face.
struct alignas(64) WallNormals {
  Vec<Lanes> normal{};
};

/// What breakage needs of eight contacts (docs/theory/bed-breakage.md).
struct alignas(64) StressHistory {
  Lanes rest{};                 ///< [m] overlap at which the contact is without force (bed.6)
  Lanes lost{};                 ///< [J] dissipated since its present loading began
  Lanes energy{};               ///< [J] put in by its last loading (bed.1)
  std::uint32_t unloading = 0;  ///< bits of lanes
};

/// Between two balls of a chunk, with a ball of another chunk, or with the wall (Chunk).
enum class ContactKind { own, halo, wall };

/// Contacts of one kind, and the free lanes.
struct ContactPackets {
  BlockList<ContactPacket> packets;
  BlockList<std::array<ContactOnset, lanes>> onsets;
  BlockList<OptionalHistory>
      optional_histories;  ///< of each packet, if the law or the rolling model needs them
  BlockList<FrictionHistory> friction_histories;  ///< likewise, for partial slip and twisting
  BlockList<PairParameters> parameters;           ///< of each packet, if curved walls change them
  BlockList<WallNormals> wall_normals;            ///< of each packet, for walls
  BlockList<std::array<geometry::NearestHulls, lanes>> hulls;  ///< likewise, if bodies are rounded
  BlockList<StressHistory> stresses;                           ///< of each packet, if grains break
  std::vector<std::int32_t> free;                              ///< lane l of packet g: 8 g + l
  /// Countdown in distribute_contacts(): copies still to be made from each block of the lists; at 0
  /// its memory is freed.
  std::vector<std::int32_t> copies_left;

  void free_block(std::size_t block) {
    packets.free_block(block);
    onsets.free_block(block);
    optional_histories.free_block(block);
    friction_histories.free_block(block);
    parameters.free_block(block);
    wall_normals.free_block(block);
    hulls.free_block(block);
    stresses.free_block(block);
  }
};

/// Verlet list of non-touching pairs, binned by gap: at the last binning, pairs of bin k had a gap
/// of at least k times the width. Only bins that the accumulated displacement can close are tested.
struct VerletList {
  static constexpr int bins = 16;
  static constexpr double width = 1.0 / 64;  ///< of the skin; the last bin has all larger gaps
  std::vector<NeighbourPair> pairs;
  std::array<std::int32_t, bins + 1> end{};  ///< of each bin
  std::vector<NeighbourPair> separated;      ///< contacts that ended since, tested at every step

  /// Number of pairs that may touch if gaps have decreased by up to `gap_decrease` [m]; `bin_width`
  /// in m.
  std::size_t due(double gap_decrease, double bin_width) const {
    const double bin = std::clamp(gap_decrease / bin_width, 0.0, bins - 1.0);
    return static_cast<std::size_t>(end[static_cast<std::size_t>(bin) + 1]);
  }
  /// Removes pair `at` in O(bins): in each bin from its own on, the last pair moves into the hole,
  /// so the hole ends up at the end of the list.
  void remove(std::size_t at) {
    for (std::size_t b = 1; b <= bins; ++b) {
      if (static_cast<std::size_t>(end[b]) <= at) continue;
      const auto last = static_cast<std::size_t>(--end[b]);
      pairs[at] = pairs[last];
      at = last;
    }
    pairs.pop_back();
  }
};

/// Displacements of a chunk's balls since the pairs were last binned. Each lies within `spread` of
/// `predicted_mean`, the mean extrapolated from earlier steps; `mean` is the true one (dem.34).
struct ChunkDisplacement {
  Vec3 predicted_mean, mean;  ///< [m]
  double spread = 0;          ///< [m]
};

/// The spheres that touch in the lanes of a packet with rounded bodies (bod.21). A sphere moves
/// with its body; `arm` is its centre from that of the body [m].
struct alignas(64) ContactSpheres {
  std::array<BallRecord, 2 * lanes> rows{};
  std::array<SpinRecord, 2 * lanes> spins{};
  LaneBodies i{0, 1, 2, 3, 4, 5, 6, 7}, j{8, 9, 10, 11, 12, 13, 14, 15};
  Vec<Lanes> arm_i{}, arm_j{};
};

/// A pair of bodies, one of them rounded, whose holding spheres overlap though they do not touch.
/// It cannot touch before ManyBodySolver::path_ has reached `due` [m].
struct NearPair {
  NeighbourPair pair;
  double due = 0;
};

/// Sums over the steps of a chunk.
struct ChunkSums {
  ContactWork work;   ///< halo contacts count half: both chunks compute them
  LiquidWork liquid;  ///< likewise
  std::int64_t ball_steps = 0, collisions = 0, sustained = 0;
  std::int64_t tests = 0;
};

/// A collision, and the step in which it ended.
struct FinishedCollision {
  std::int64_t step = 0;
  scene::Collision collision;
};

/// A chunk of neighbouring balls: rows first to last - 1, and their contacts. `own`: between two
/// balls of the chunk. `halo`: with a ball of another chunk, which also computes the contact.
/// `wall`: with the wall.
struct Chunk {
  std::int32_t first = 0, last = 0;
  ContactPackets own, halo, wall;
  VerletList ball_pairs, wall_pairs;
  std::vector<NearPair> near_pairs;  ///< taken out of both lists
  /// [m] Upper bounds of the decrease of gaps since the last binning.
  double max_gap_decrease = 0, max_wall_gap_decrease = 0;
  std::vector<std::int32_t> neighbour_chunks;  ///< chunks with balls near those of this chunk
  std::int32_t balls_in_contact = 0;           ///< balls with contacts
  ChunkSums sums;
  std::vector<scene::WallLoad> loads;  ///< like `sums`; none without parts
  std::vector<FinishedCollision> finished;
  /// Of the lanes of `wall`, where the wall keeps them. They change no result and are not saved.
  std::vector<std::array<geometry::NearFacets, lanes>> near_facets;
  std::vector<geometry::NearFacets> tested_facets;  ///< likewise, of pairs in `wall_pairs`
  std::vector<std::int32_t> new_touches;            ///< scratch: pairs found to touch
  ContactSpheres spheres;                           ///< scratch: of the packet that is computed
  double largest_move = 0;  ///< [m] of a point of a body of the chunk in this step; if rounded
  std::int32_t meeting_cores = -1;  ///< row of a rounded body whose core is pressed in; < 0: none
};

}  // namespace mahlwerk::soft
