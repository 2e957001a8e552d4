// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/contact/law.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::event {

/// Time [s] within which bodies that bounced at `first` [m/s] and again at `second` belong to one
/// contact: the durations of both contacts by Hertz's law (man.9). Slower bounces count as ones at
/// 1 mm/s.
double joining_time(const contact::EffectivePair& pair, double first, double second);

/// Joins the bounces of one contact to one record, as the soft engine has one for each contact
/// (man.9): time, place and speeds of the first bounce, the time from the first to the last as
/// duration, and the sums of impulses and losses. A record is finished when no further bounce can
/// belong to it. Records are finished in the order of their ends, whatever the calls.
class ContactRecords {
 public:
  /// For `balls` balls; `longest` [s] is the longest joining time of any pair.
  ContactRecords(std::size_t balls, double longest) : first_(balls, none), longest_(longest) {}

  /// A bounce of two bodies, as in scene::Collision.
  struct Bounce {
    double time = 0;
    std::int32_t ball = 0, other = 0;
    double approach = 0, impulse = 0, lost_normal = 0, lost_tangential = 0;
  };
  /// Joins the bounce to the record of its contact, if it continues one; returns whether it does.
  /// Bounces come in the order of time. `pair` has the radius, the mass and the modulus of the two.
  bool join(const Bounce& bounce, const contact::EffectivePair& pair);
  /// Begins a contact with the bounce `first`, which does not continue one.
  void begin(const scene::Collision& first);
  /// Moves the records that no bounce from `time` [s] on can belong to into `finished`.
  void finish_before(double time, std::vector<scene::Collision>& finished);
  double lost() const;  ///< [J] by contacts whose records are not finished
  /// Takes losses and impulses so far out of the records that are not finished.
  void begin_counting();

  /// Throws RunError where the bytes read are inconsistent.
  void serialize(Archive& archive);

 private:
  static constexpr std::int32_t none = -1;
  struct Contact {
    scene::Collision record;
    double first_duration = 0;  // [s] of an elastic contact at the first bounce; 0: not computed
    double last = 0;            // [s] time of the last bounce
    std::int32_t next = none;   // contact of the same ball, or free entry
    std::int32_t earlier = none, later = none;  // by the time of the last bounce
  };

  Contact& at(std::int32_t index) { return contacts_[static_cast<std::size_t>(index)]; }
  std::int32_t& first_of(std::int32_t ball) { return first_[static_cast<std::size_t>(ball)]; }
  static bool continues(Contact& contact, const Bounce& bounce, const contact::EffectivePair& pair);
  void take_from_ball(std::int32_t index);
  void append(std::int32_t index);
  void unlink(std::int32_t index);
  bool is_consistent() const;

  std::vector<Contact> contacts_;    // open ones and free ones
  std::vector<std::int32_t> first_;  // of each ball, the first contact that a bounce may continue
  std::int32_t free_ = none, earliest_ = none, latest_ = none;
  double longest_;
};

}  // namespace mahlwerk::event
