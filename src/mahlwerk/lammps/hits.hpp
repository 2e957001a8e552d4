// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/lammps/impact.hpp"
#include "mahlwerk/lammps/jar.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::lammps {

/// Makes records of collisions from what LAMMPS tells of contacts (lmp.8 to lmp.11).
class Hits {
 public:
  /// `balls` give radii and masses. Contacts with the jar below `slowest` [m/s] are left out, and
  /// sliding speeds of two balls are kept above it.
  Hits(const cases::Case& mill_case, const scene::Chamber& chamber, std::vector<scene::Ball> balls,
       double slowest);

  /// A contact of two balls that ended: between which, when [s], their least distance [m] and the
  /// middle of the contact in the jar frame [m].
  struct BallContact {
    std::int32_t one = 0, other = 0;
    double began = 0, ended = 0, distance = 0;
    Vec3 middle;
  };
  scene::Collision between_balls(const BallContact& contact);

  /// Adds to `found` the collisions of a ball near the jar that no earlier sample has shown. `now`:
  /// the ball at `time` [s] in the jar frame. Samples of a ball must come in order of time.
  void sample_at_jar(std::int32_t ball, const scene::Ball& now, double time,
                     std::vector<scene::Collision>& found);

  /// Takes the sliding speeds of all contacts of two balls in a frame.
  void sample_between_balls(const std::vector<scene::Ball>& balls);

  double deepest_overlap() const { return deepest_; }  ///< [1] over the smaller radius

 private:
  /// Speeds of a contact across its normal [m/s]: of the touching surfaces, and of the centres.
  struct Sliding {
    double slip = 0, glide = 0;
  };
  /// The last contacts of one class of approach speed.
  struct SlidingClass {
    std::vector<Sliding> kept;
    std::size_t next = 0, given = 0;
  };
  static constexpr int classes = 24;  // of a factor sqrt(2) from `slowest_` on
  using SlidingByClass = std::array<SlidingClass, classes>;

  const Impact& impact_of_balls(int one, int other);
  const Impact& impact_at_jar(int type, int face, double curvature);
  int class_of(double speed) const;
  SlidingByClass& sliding_of(int one, int other);
  Sliding sliding_at(SlidingByClass& classes, double speed) const;
  void sample_pair(const scene::Ball& a, const scene::Ball& b, int one, int other);

  const cases::Case* mill_case_;
  contact::PairTable pairs_;
  Jar jar_;
  std::vector<scene::Ball> balls_;
  std::vector<int> types_;
  double slowest_, deepest_ = 0;
  std::map<std::pair<int, int>, Impact> between_, at_jar_;
  std::map<std::pair<int, int>, SlidingByClass> sliding_;
  std::unordered_map<std::int64_t, double> touching_;  // end of the last contact of ball and face
};

}  // namespace mahlwerk::lammps
