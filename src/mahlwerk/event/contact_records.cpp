// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/contact_records.hpp"

#include <algorithm>

#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::event {

double joining_time(const contact::EffectivePair& pair, double first, double second) {
  constexpr double slowest = 1e-3;  // [m/s]
  return contact::hertz_time(pair, std::max(first, slowest)) +
         contact::hertz_time(pair, std::max(second, slowest));
}

bool ContactRecords::add(const scene::Collision& bounce, const contact::EffectivePair& pair) {
  const std::int32_t index = find(bounce);
  if (index != none) {
    Contact& contact = at(index);
    scene::Collision& record = contact.record;
    if (bounce.time - contact.last < joining_time(pair, record.approach, bounce.approach)) {
      record.duration = bounce.time - record.time;
      record.impulse += bounce.impulse;
      record.lost_normal += bounce.lost_normal;
      record.lost_tangential += bounce.lost_tangential;
      contact.last = bounce.time;
      unlink(index);
      append(index);
      return false;
    }
    take_from_ball(index);
  }
  begin(bounce);
  return true;
}

void ContactRecords::finish_before(double time, std::vector<scene::Collision>& finished) {
  while (earliest_ != none && at(earliest_).last + longest_ < time) {
    const std::int32_t index = earliest_;
    finished.push_back(at(index).record);
    take_from_ball(index);
    unlink(index);
    at(index).next = free_;
    free_ = index;
  }
}

double ContactRecords::lost() const {
  double sum = 0;
  for (std::int32_t i = earliest_; i != none; i = contacts_[static_cast<std::size_t>(i)].later)
    sum += contacts_[static_cast<std::size_t>(i)].record.lost();
  return sum;
}

/// The contact of the pair of `bounce`, or none.
std::int32_t ContactRecords::find(const scene::Collision& bounce) {
  std::int32_t index = first_of(bounce);
  while (index != none && at(index).record.other != bounce.other) index = at(index).next;
  return index;
}

void ContactRecords::begin(const scene::Collision& bounce) {
  std::int32_t index = free_;
  if (index == none) {
    index = static_cast<std::int32_t>(contacts_.size());
    contacts_.emplace_back();
  } else {
    free_ = at(index).next;
  }
  Contact& contact = at(index);
  contact.record = bounce;
  contact.last = bounce.time;
  contact.next = first_of(bounce);
  first_of(bounce) = index;
  append(index);
}

/// Takes a contact from the list of its ball, if it is still there: no bounce continues it.
void ContactRecords::take_from_ball(std::int32_t index) {
  std::int32_t* link = &first_of(at(index).record);
  while (*link != none && *link != index) link = &at(*link).next;
  if (*link == index) *link = at(index).next;
}

void ContactRecords::append(std::int32_t index) {
  at(index).earlier = latest_;
  at(index).later = none;
  (latest_ == none ? earliest_ : at(latest_).later) = index;
  latest_ = index;
}

void ContactRecords::unlink(std::int32_t index) {
  const Contact& contact = at(index);
  (contact.earlier == none ? earliest_ : at(contact.earlier).later) = contact.later;
  (contact.later == none ? latest_ : at(contact.later).earlier) = contact.earlier;
}

void ContactRecords::serialize(Archive& archive) {
  const std::size_t balls = first_.size();
  archive(contacts_)(first_)(free_)(earliest_)(latest_);
  if (archive.reading() && (first_.size() != balls || !is_consistent())) throw Archive::broken();
}

/// Whether all indices exist, each contact is open or free, and the lists agree with one another.
bool ContactRecords::is_consistent() const {
  const auto count = std::ssize(contacts_);
  const auto exists = [&](std::int32_t index) { return index >= 0 && index < count; };
  std::vector<bool> seen(contacts_.size());
  const auto visit_once = [&](std::int32_t index) {
    if (!exists(index) || seen[static_cast<std::size_t>(index)]) return false;
    return static_cast<bool>(seen[static_cast<std::size_t>(index)] = true);
  };
  const auto contact = [&](std::int32_t index) -> const Contact& {
    return contacts_[static_cast<std::size_t>(index)];
  };
  std::int32_t before = none;
  for (std::int32_t i = earliest_; i != none; before = i, i = contact(i).later)
    if (!visit_once(i) || contact(i).earlier != before || contact(i).record.ball < 0 ||
        contact(i).record.ball >= std::ssize(first_))
      return false;
  if (before != latest_) return false;
  const std::vector<bool> open = seen;
  for (std::int32_t i = free_; i != none; i = contact(i).next)
    if (!visit_once(i)) return false;
  if (std::ranges::find(seen, false) != seen.end()) return false;
  seen.assign(contacts_.size(), false);
  for (std::int32_t ball = 0; ball < std::ssize(first_); ++ball)
    for (std::int32_t i = first_[static_cast<std::size_t>(ball)]; i != none; i = contact(i).next)
      if (!visit_once(i) || !open[static_cast<std::size_t>(i)] || contact(i).record.ball != ball)
        return false;
  return true;
}

}  // namespace mahlwerk::event
