// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/lammps/impact.hpp"
#include "mahlwerk/lammps/jar.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::lammps {

/// Speeds at first touch [m/s]: along the normal; across it, of the touching surfaces and of the
/// centres.
struct TouchSpeeds {
  double approach = 0, slip = 0, glide = 0;
};

/// Speeds of the contacts that were seen soon after their first touch, for those that were not:
/// each gets the speeds of a seen one of the same pair of types, with about the same strongest
/// compression, and with a duration of the same kind (lmp.10). By turns, so that many contacts get
/// the distribution of the seen ones.
class SeenContacts {
 public:
  /// `strength` [m/s]: speed of an undisturbed collision with the contact's largest overlap.
  /// `brief`: whether it lasted about as long as such a collision.
  void add(std::pair<int, int> types, double strength, bool brief, const TouchSpeeds& speeds);
  /// Their approach is in proportion to `strength`. Without any seen contact of these types:
  /// `strength` alone.
  TouchSpeeds like(std::pair<int, int> types, double strength, bool brief);

 private:
  static constexpr int classes = 64;  // of a factor sqrt(2) from 1e-6 m/s on
  static int class_of(double strength);
  struct Class {
    std::vector<TouchSpeeds> kept;  // the approach over strength
    std::size_t next = 0, given = 0;
  };
  std::map<std::pair<int, int>, std::vector<Class>> seen_;  // brief ones first
};

/// Makes records of collisions from what LAMMPS tells of contacts (lmp.8 to lmp.11).
class Hits {
 public:
  /// `balls` give radii and masses. Steps are numbers of `time_step` [s].
  Hits(const cases::Case& mill_case, const scene::Chamber& chamber, std::vector<scene::Ball> balls,
       double time_step);

  /// A contact of two balls that ended: between which, at which steps, their least distance [m] and
  /// the middle of the contact in the jar frame [m].
  struct BallContact {
    std::int32_t one = 0, other = 0;
    std::int64_t began = 0, ended = 0;
    double distance = 0;
    Vec3 middle;
  };
  scene::Collision between_balls(const BallContact& contact);

  /// A ball, in the jar frame at `step`, which has come into contact with a face of the jar or left
  /// one since the last look. Adds to `found` the collisions that ended.
  void at_jar(std::int32_t ball, const scene::Ball& now, std::int64_t step,
              std::vector<scene::Collision>& found);

  /// Looks at all contacts of two balls in a frame. Returns the number of balls in contact.
  std::int64_t look(const std::vector<scene::Ball>& balls, std::int64_t step);

  double deepest_overlap() const { return deepest_; }  ///< [1] over the smaller radius
  /// A ball whose centre the last look found outside the jar, if there is one.
  std::optional<std::int32_t> outside() const { return outside_; }
  /// Number of contacts that lasted five times as long as a collision.
  std::int64_t lasting() const { return lasting_; }

 private:
  struct Seen {
    std::int64_t step = 0;
    TouchSpeeds speeds;
  };
  const Impact& impact_of_balls(std::int32_t one, std::int32_t other);
  const Impact& impact_at_jar(std::int32_t ball, int face, double curvature);
  std::pair<int, int> types_of_pair(std::int32_t one, std::int32_t other) const;
  bool look_at_pair(const scene::Ball& a, const scene::Ball& b, std::int32_t one,
                    std::int32_t other, std::int64_t step);
  /// The speeds of a contact that a look has shown within `soon` [s] of its begin, if one has.
  std::optional<TouchSpeeds> seen(const BallContact& contact, double soon);
  scene::Collision begin_at_jar(std::int32_t ball, const scene::Ball& now, const scene::Wall& wall,
                                int face, double time);
  /// [s] How long after first touch a contact of this duration [s] still shows its speed then.
  double soon(double duration) const;
  double time_of(std::int64_t step) const { return static_cast<double>(step) * time_step_; }
  bool touches_jar(std::int32_t number, const scene::Ball& ball, double time);

  const cases::Case* mill_case_;
  contact::PairTable pairs_;
  Jar jar_;
  std::vector<scene::Ball> balls_;
  std::vector<int> types_;
  double time_step_, deepest_ = 0;
  std::int64_t lasting_ = 0;
  std::optional<std::int32_t> outside_;
  std::map<std::pair<int, int>, Impact> between_, at_jar_;
  std::unordered_map<std::uint64_t, std::vector<Seen>> looked_at_;  // contacts in looks, by pair
  SeenContacts seen_;
  std::unordered_map<std::int64_t, scene::Collision> touching_;  // the jar, by ball and face
};

}  // namespace mahlwerk::lammps
