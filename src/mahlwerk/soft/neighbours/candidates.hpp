// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/soft/kernel/ball_record.hpp"

namespace mahlwerk::soft {

/// Candidates for neighbours of a few balls that lie close together. Structure of arrays; eight
/// distance tests at a time.
class Candidates {
 public:
  /// `periods` [m] are infinite where the box is not periodic.
  explicit Candidates(const Vec3& periods);

  void clear() { count_ = 0; }
  /// Adds the balls of rows first to last - 1.
  void add(const BallRecord* rows, std::int32_t first, std::int32_t last);

  struct Neighbour {
    std::int32_t row = 0;
    double gap = 0;  ///< [m] from the query position to the surface
  };
  struct Query {
    Vec3 position;
    double beyond = 0;                   ///< [m] largest gap
    std::int32_t after = 0, before = 0;  ///< only rows > after, or < before
  };
  /// The candidates with a gap below `beyond`. The result is valid until the next call.
  std::span<const Neighbour> find_near(const Query& query);

 private:
  struct Block {
    Lanes x{}, y{}, z{}, radius{}, row{};
  };
  struct Search;
  template <class V>
  void find(const Query& query);
  template <class V>
  MaskOf<V> test(const LaneGroup<V>& group, const Block& b, const Query& query, V& squared) const;

  Vec3 periods_;
  bool periodic_;
  void (*find_)(Candidates&, const Query&);  // compiled for the instruction set of this machine
  std::vector<Block> blocks_;
  std::vector<Neighbour> found_;
  std::size_t count_ = 0;
};

}  // namespace mahlwerk::soft
