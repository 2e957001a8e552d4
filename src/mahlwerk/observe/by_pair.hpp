// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mahlwerk/observe/histogram.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::observe {

/// Which kind each ball is of; shared by all who count.
class BallKinds {
 public:
  BallKinds() = default;  ///< nobody asks
  BallKinds(std::vector<std::int32_t> of_ball, int kinds)
      : of_ball_(std::make_shared<const std::vector<std::int32_t>>(std::move(of_ball))),
        kinds_(kinds) {}
  int kinds() const { return kinds_; }
  std::int32_t of(std::int32_t ball) const { return (*of_ball_)[static_cast<std::size_t>(ball)]; }

 private:
  std::shared_ptr<const std::vector<std::int32_t>> of_ball_;
  int kinds_ = 0;
};

/// Sums over the collisions of one kind of pair.
struct PairSums {
  std::int64_t count = 0;
  double energy_normal = 0, energy_contact_point = 0;  // [J]
  double lost_normal = 0, lost_tangential = 0;         // [J]

  void add(const PairSums& o) {
    count += o.count;
    energy_normal += o.energy_normal;
    energy_contact_point += o.energy_contact_point;
    lost_normal += o.lost_normal;
    lost_tangential += o.lost_tangential;
  }
};

/// What one kind of pair's collisions add up to.
struct PairTally {
  PairSums all, above;         // above: u_n >= threshold
  LogHistogram energy_normal;  // [J]
};

/// A tally for each two kinds of balls, and for each kind with the jar, in fixed memory. Empty, and
/// silent, without kinds.
class ByPair {
 public:
  ByPair() = default;
  explicit ByPair(BallKinds kinds);

  /// `bin` of its normal energy in a LogHistogram.
  void add(const scene::Collision& c, bool above, int bin);
  void merge(const ByPair& other);  ///< of the same kinds
  void carry(Archive& archive);

  int kinds() const { return kinds_.kinds(); }
  int pairs() const { return static_cast<int>(tallies_.size()); }
  /// Kinds of a pair: the first, and the other, which is not below it, or `jar`.
  struct Kinds {
    int one = 0, other = 0;
  };
  static constexpr int jar = -1;
  Kinds kinds_of(int pair) const;
  const PairTally& operator[](int pair) const { return tallies_[static_cast<std::size_t>(pair)]; }

 private:
  BallKinds kinds_;
  std::vector<PairTally> tallies_;    // each pair once
  std::vector<std::int32_t> number_;  // of a pair: a row for each kind, the jar at its end
};

}  // namespace mahlwerk::observe
