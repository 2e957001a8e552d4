// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/scene/collision.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"
#include "mahlwerk/soft/kernel/contact_force.hpp"
#include "mahlwerk/soft/neighbours/pair_gaps.hpp"

namespace mahlwerk::soft {

/// Eight contacts side by side: those that touch, and nothing else. Free lanes touch nothing, but
/// name bodies that there are.
struct alignas(64) ContactPacket {
  std::array<std::int32_t, lanes> i{}, j{};  ///< balls; j of a wall: its face
  std::array<std::int32_t, lanes> species_pair{};
  std::uint32_t touching = 0, begun = 0;  ///< bits of lanes; of those that first do in this step
  std::uint32_t pulling = 0;              ///< where the bodies pulled each other at the last step
  bool one_species_pair = true;           ///< all lanes are of one species pair
  Vec<Lanes> spring{};
  Lanes impulse{}, lost_normal{}, lost_tangential{};  ///< since they began

  bool touches(int lane) const { return (touching & bit(lane)) != 0; }
};
/// What only some laws remember.
struct alignas(64) OptionalHistory {
  Lanes law_history[contact::law_history_size]{};
  Vec<Lanes> roll{};
  Lanes stiffness{};  ///< where the spring across gives way as contacts unload
};

/// The normals of walls at the last step: a contact that ends may have left its face.
struct alignas(64) WallNormals {
  Vec<Lanes> normal{};
};

/// Contacts of one kind, with the lanes that are free.
struct ContactPackets {
  std::vector<ContactPacket> packets;
  std::vector<std::array<ContactOnset, lanes>> onset;
  std::vector<OptionalHistory>
      optional_histories;  ///< of each packet, where the law or the rolling needs them
  std::vector<PairParameters> parameters;  ///< of each packet, where curved walls change them
  std::vector<WallNormals> wall_normals;   ///< of each packet with walls
  std::vector<std::int32_t> free;          ///< lane l of packet g: 8 g + l
  std::int32_t leaving = 0;                ///< contacts that move to a new order of the balls

  /// Where contacts remember, or are bent, for that, too.
  void reserve(std::size_t count, bool with_history, bool curved) {
    packets.reserve(count);
    onset.reserve(count);
    if (with_history) optional_histories.reserve(count);
    if (curved) parameters.reserve(count);
  }
};

/// Pairs that are near and do not touch, by their gap when they were last sorted: those of bin k
/// had at least k times the width. Only bins that the motion since can close are tested.
struct VerletList {
  static constexpr int bins = 16;
  static constexpr double width = 1.0 / 64;  ///< of the skin; the last bin has all wider gaps
  std::vector<NeighbourPair> pairs;
  std::array<std::int32_t, bins + 1> end{};  ///< of each bin
  std::vector<NeighbourPair> separated;      ///< have touched since, tested at every step

  /// Pairs that may touch where bodies have come nearer by `bound`, bins being `width` wide.
  std::size_t due(double bound, double bin_width) const {
    const double bin = std::clamp(bound / bin_width, 0.0, bins - 1.0);
    return static_cast<std::size_t>(end[static_cast<std::size_t>(bin) + 1]);
  }
  /// The last of each bin takes the place of what it gives to the bin before.
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

/// How far the balls of a chunk have moved since the neighbour list was built: all by
/// `predicted_mean`, give or take `spread`.
struct ChunkDisplacement {
  Vec3 predicted_mean, mean;  ///< [m]
  double spread = 0;          ///< [m]
};

/// Sums over the steps of a chunk.
struct ChunkSums {
  ContactWork work;  ///< half of those of a pair with another chunk, for both compute them
  std::int64_t ball_steps = 0, collisions = 0, lasting = 0;
  std::int64_t tests = 0;
};

/// A collision that ended, and when.
struct FinishedCollision {
  std::int64_t step = 0;
  scene::Collision collision;
};

/// Balls first to last of the rows, which lie near each other, and their contacts: of two of them;
/// of one and a ball of another chunk, which has the contact, too; with the wall.
struct Chunk {
  std::int32_t first = 0, last = 0;
  ContactPackets own, halo, wall;
  VerletList ball_pairs, wall_pairs;
  double bound = 0, wall_bound = 0;            ///< [m] pairs may have come so much nearer
  std::vector<std::int32_t> neighbour_chunks;  ///< chunks that have balls near to its own
  std::int32_t balls_in_contact = 0;           ///< balls that touch something
  ChunkSums sums;
  std::vector<FinishedCollision> finished;
  std::vector<std::int32_t> new_touches;  ///< pairs found to touch, while looking
};

}  // namespace mahlwerk::soft
