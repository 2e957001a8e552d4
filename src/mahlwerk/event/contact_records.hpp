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

  /// Adds the bounce of a pair, not earlier than any before. `pair` holds the radius, the mass and
  /// the modulus of the two bodies. Returns whether it begins a contact.
  bool add(const scene::Collision& bounce, const contact::EffectivePair& pair);
  /// Moves the records that no bounce from `time` [s] on can belong to into `finished`.
  void finish_before(double time, std::vector<scene::Collision>& finished);
  double lost() const;  ///< [J] by contacts whose records are not finished

  /// Throws RunError where the bytes read are inconsistent.
  void serialize(Archive& archive);

 private:
  static constexpr std::int32_t none = -1;
  struct Contact {
    scene::Collision record;
    double last = 0;                            // [s] time of the last bounce
    std::int32_t next = none;                   // contact of the same ball, or free entry
    std::int32_t earlier = none, later = none;  // by the time of the last bounce
  };

  Contact& at(std::int32_t index) { return contacts_[static_cast<std::size_t>(index)]; }
  std::int32_t& first_of(const scene::Collision& record) {
    return first_[static_cast<std::size_t>(record.ball)];
  }
  std::int32_t find(const scene::Collision& bounce);
  void begin(const scene::Collision& bounce);
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
