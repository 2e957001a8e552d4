// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <numeric>
#include <optional>
#include <vector>

#include "mahlwerk/observe/collision_batch.hpp"
#include "mahlwerk/observe/spectra.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::observe {

/// Kind of each ball, and distinguished faces of the jar and its parts. Copies share the tables.
class BallKinds {
 public:
  BallKinds() : BallKinds({}, 1, 1) {}  ///< all of one kind, in a jar of one face
  /// `of_ball`: kind of each ball; empty if all are of kind 0. Later balls, fragments of grains,
  /// are of the kind of the last. Faces from `faces` - 1 count as one.
  BallKinds(std::vector<std::int32_t> of_ball, int kinds, int faces)
      : BallKinds(std::move(of_ball), kinds, each_of(faces)) {}
  /// `of_face`: the distinguished face, from 0, that each face counts as; faces after the last as
  /// that one.
  BallKinds(std::vector<std::int32_t> of_ball, int kinds, std::vector<std::int32_t> of_face)
      : of_ball_(std::make_shared<const std::vector<std::int32_t>>(std::move(of_ball))),
        of_face_(std::make_shared<const std::vector<std::int32_t>>(std::move(of_face))),
        kinds_(kinds),
        faces_(std::ranges::max(*of_face_) + 1) {}
  int kinds() const { return kinds_; }
  int faces() const { return faces_; }
  std::int32_t face(std::int32_t face) const {
    const auto last = static_cast<std::int32_t>(of_face_->size()) - 1;
    return (*of_face_)[static_cast<std::size_t>(std::min(face, last))];
  }
  std::int32_t of(std::int32_t ball) const {
    if (of_ball_->empty()) return 0;
    return (*of_ball_)[std::min(static_cast<std::size_t>(ball), of_ball_->size() - 1)];
  }

 private:
  static std::vector<std::int32_t> each_of(int faces) {
    std::vector<std::int32_t> all(static_cast<std::size_t>(std::max(faces, 1)));
    std::iota(all.begin(), all.end(), 0);
    return all;
  }

  std::shared_ptr<const std::vector<std::int32_t>> of_ball_, of_face_;
  int kinds_ = 1, faces_ = 1;
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

/// Factors from a pair's losses to wear and flash temperature.
struct PairFactors {
  double load_distance_per_loss = 0;  ///< [1] load times distance over tangential loss (wea.3)
  /// [K/J] Flash temperature rise over energy lost, by bin of normal energy (hea.7). If empty,
  /// flash temperatures are not computed.
  std::vector<double> flash_per_loss;
  std::vector<double> hertz_time;  ///< [s] Hertz's contact time, by the same bins (hea.9)
  /// [1] Duration of an impact with the given moduli over that in the run (hea.11)
  double softened_duration = 1;
};

/// Collision statistics of one kind of pair.
struct PairStatistics {
  PairSums above;  ///< collisions with u_n >= threshold
  Spectra spectra;
  double load_distance = 0;  ///< [N m] integral of normal force over sliding distance
  double erosion = 0;        ///< [J] sum of m u^2 f(alpha) (wea.4)
  double flash = 0;          ///< [K J] sum of flash temperature rise times energy lost

  PairSums all() const;
  void let_go();  ///< forgets the spectra, but not the sums
  void add(const CollisionBatch& c, std::size_t i, bool above, const PairFactors& factors);
  void merge(const PairStatistics& other);
  void serialize(Archive& archive);

 private:
  std::optional<PairSums> all_;  // of spectra that were let go
};

/// Statistics for each pair of ball kinds, and for each kind with each face of the jar. Memory for
/// a pair is allocated at its first collision.
class StatisticsByPair {
 public:
  explicit StatisticsByPair(BallKinds kinds = {});

  int pair_of(const scene::Collision& c) const {
    const std::int32_t row = kinds_.kinds() + kinds_.faces();
    const std::int32_t other =
        c.other < 0 ? kinds_.kinds() + kinds_.face(~c.other) : kinds_.of(c.other);
    return number_[static_cast<std::size_t>(kinds_.of(c.ball) * row + other)];
  }
  /// The statistics of a pair, for counting.
  PairStatistics& at(int pair);
  const PairFactors& factors(int pair) const { return factors_[static_cast<std::size_t>(pair)]; }
  void set_factors(int pair, PairFactors factors) {
    factors_[static_cast<std::size_t>(pair)] = std::move(factors);
  }
  void merge(const StatisticsByPair& other);  ///< of the same kinds
  void pack();                                ///< nothing is added from then on
  void let_go();                              ///< of each pair (PairStatistics)
  void serialize(Archive& archive);

  int kinds() const { return kinds_.kinds(); }
  int faces() const { return kinds_.faces(); }
  int pairs() const { return static_cast<int>(statistics_.size()); }
  /// Kinds of a pair: `one`, and `other` >= `one` or, with the jar, `other` = ~face, a
  /// distinguished one.
  struct Kinds {
    int one = 0, other = 0;
    bool with_jar() const { return other < 0; }
    int face() const { return ~other; }
  };
  Kinds kinds_of(int pair) const;
  /// The statistics of a pair; empty statistics for a pair without collisions.
  const PairStatistics& operator[](int pair) const;

 private:
  BallKinds kinds_;
  std::vector<std::vector<PairStatistics>> statistics_;  // by pair: one element, or none yet
  std::vector<PairFactors> factors_;
  std::vector<std::int32_t> number_;  // pair index by kinds: a row per kind, faces at its end
};

}  // namespace mahlwerk::observe
