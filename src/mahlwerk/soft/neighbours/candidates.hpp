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

/// Balls that may be neighbours of a few that lie together, in columns, tested eight at a time.
class Candidates {
 public:
  /// `periods` [m] are infinite where the box does not repeat.
  explicit Candidates(const Vec3& periods);

  void clear() { count_ = 0; }
  /// Balls first to last of the rows.
  void add(const BallRecord* rows, std::int32_t first, std::int32_t last);

  struct Neighbour {
    std::int32_t row = 0;
    double gap = 0;  ///< [m] to the surface
  };
  struct Query {
    Vec3 position;
    double beyond = 0;                   ///< [m] from the surfaces of those that are found, or less
    std::int32_t after = 0, before = 0;  ///< rows after the one, or before the other
  };
  /// Those that are near, until the next are sought. Their gaps are to the point `position`.
  std::span<const Neighbour> find_near(const Query& query);

 private:
  struct alignas(64) Block {
    Lanes x{}, y{}, z{}, radius{}, row{};
  };
  struct Search;
  void find(const Query& query);
  LaneMask test(const Block& b, const Query& query, Lanes& squared) const;

  Vec3 periods_;
  bool periodic_;
  void (*find_)(Candidates&, const Query&);  // for this machine
  std::vector<Block> blocks_;
  std::vector<Neighbour> found_;
  std::size_t count_ = 0;
};

}  // namespace mahlwerk::soft
