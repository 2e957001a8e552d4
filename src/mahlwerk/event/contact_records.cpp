// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/contact_records.hpp"

#include <algorithm>

#include "mahlwerk/contact/hertz.hpp"

namespace mahlwerk::event {

namespace {

/// Duration [s] of an elastic contact that begins at `approach` [m/s], at least 1 mm/s.
double contact_duration(const contact::EffectivePair& pair, double approach) {
  constexpr double slowest = 1e-3;  // [m/s]
  return contact::hertz_time(pair, std::max(approach, slowest));
}

}  // namespace

double joining_time(const contact::EffectivePair& pair, double first, double second) {
  return contact_duration(pair, first) + contact_duration(pair, second);
}

/// Whether a bounce follows the last one of `contact` within the joining time. Most bounces of
/// sustained contacts do so within its first part, which is computed once.
bool ContactRecords::continues(Contact& contact, const Bounce& bounce,
                               const contact::EffectivePair& pair) {
  const double since = bounce.time - contact.last;
  if (contact.first_duration == 0)
    contact.first_duration = contact_duration(pair, contact.record.approach);
  return since < contact.first_duration ||
         since < contact.first_duration + contact_duration(pair, bounce.approach);
}

bool ContactRecords::join(const Bounce& bounce, const contact::EffectivePair& pair) {
  std::int32_t index = first_of(bounce.ball);
  while (index != none && at(index).record.other != bounce.other) index = at(index).next;
  if (index == none) return false;
  Contact& contact = at(index);
  if (!continues(contact, bounce, pair)) {
    take_from_ball(index);
    return false;
  }
  scene::Collision& record = contact.record;
  record.duration = bounce.time - record.time;
  record.impulse += bounce.impulse;
  record.lost_normal += bounce.lost_normal;
  record.lost_tangential += bounce.lost_tangential;
  contact.last = bounce.time;
  if (index != latest_) {
    unlink(index);
    append(index);
  }
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

void ContactRecords::begin_counting() {
  for (std::int32_t i = earliest_; i != none; i = at(i).later) {
    scene::Collision& record = at(i).record;
    record.impulse = record.lost_normal = record.lost_tangential = 0;
  }
}

void ContactRecords::begin(const scene::Collision& first) {
  std::int32_t index = free_;
  if (index == none) {
    index = static_cast<std::int32_t>(contacts_.size());
    contacts_.emplace_back();
  } else {
    free_ = at(index).next;
  }
  Contact& contact = at(index);
  contact.record = first;
  contact.first_duration = 0;
  contact.last = first.time;
  contact.next = first_of(first.ball);
  first_of(first.ball) = index;
  append(index);
}

/// Takes a contact from the list of its ball, if it is still there: no bounce continues it.
void ContactRecords::take_from_ball(std::int32_t index) {
  std::int32_t* link = &first_of(at(index).record.ball);
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
