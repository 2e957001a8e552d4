// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/calendar_queue.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace mahlwerk::event {
namespace {

constexpr double per_slice = 12;  // events; few enough for insertion sort
constexpr std::int64_t far_away = std::numeric_limits<std::int64_t>::max();

}  // namespace

void CalendarQueue::start(std::span<const double> times, double now) {
  times_.assign(times.begin(), times.end());
  origin_ = now;
  start_at(rate(), now);
}

void CalendarQueue::start_at(double rate, double now) {
  bucket_count_ =
      static_cast<std::int64_t>(std::bit_ceil(std::max<std::size_t>(64, 2 * times_.size())));
  buckets_.assign(static_cast<std::size_t>(bucket_count_), -1);
  pool_.clear();
  free_ = ahead_ = -1;
  bucketed_ = 0;
  open_.clear();
  overflow_.clear();
  slice_ = opened_ = 0;
  origin_ = now;
  slices_per_second_ = std::clamp(rate, 1e-9, 1e15) / per_slice;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    const auto ball = static_cast<std::int32_t>(i);
    const std::int64_t slice = slice_of(times_[i]);
    if (slice <= slice_)
      open_.push_back({times_[i], ball, -1});  // sorted below, because there may be many
    else
      add_entry(slice, times_[i], ball);
  }
  sort_open();
}

void CalendarQueue::sort_open() {
  std::ranges::sort(open_, [](const Entry& a, const Entry& b) {
    return a.time > b.time || (a.time == b.time && a.ball > b.ball);
  });
}

/// Changes the slice width if slices turn out far too full or too empty.
void CalendarQueue::retune() {
  const std::int64_t enough = std::ssize(times_) + 64;
  if (opened_ < enough && slice_ < 4 * bucket_count_) return;
  const double mean = static_cast<double>(opened_) / static_cast<double>(slice_ + 1);
  if (mean > per_slice / 4 && mean < 4 * per_slice) return;
  const double now = origin_ + static_cast<double>(slice_) / slices_per_second_;
  start_at(mean * slices_per_second_, now);
}

/// Events per second in the near future, from the time at which the first tenth is over.
double CalendarQueue::rate() const {
  std::vector<double> sorted(times_.begin(), times_.end());
  const auto tenth = sorted.begin() + std::ssize(sorted) / 10;
  std::ranges::nth_element(sorted, tenth);
  const double events = static_cast<double>(tenth - sorted.begin() + 1);
  return events / (*tenth - origin_);
}

std::int64_t CalendarQueue::slice_of(double time) const {
  const double slice = (time - origin_) * slices_per_second_;
  return slice < 1e18 ? static_cast<std::int64_t>(std::max(slice, 0.0)) : far_away;
}

void CalendarQueue::schedule(std::int32_t ball, double time) {
  times_[static_cast<std::size_t>(ball)] = time;
  add_entry(slice_of(time), time, ball);
}

void CalendarQueue::add_entry(std::int64_t slice, double time, std::int32_t ball) {
  if (slice <= slice_) return insert_into_open(time, ball);
  if (slice >= slice_ + bucket_count_) {
    if (time < std::numeric_limits<double>::infinity()) overflow_.push_back({time, ball, -1});
    return;
  }
  std::int32_t at = free_;
  if (at >= 0) {
    free_ = pool_[static_cast<std::size_t>(at)].next;
  } else {
    at = static_cast<std::int32_t>(pool_.size());
    pool_.emplace_back();
  }
  std::int32_t& first = buckets_[static_cast<std::size_t>(slice & (bucket_count_ - 1))];
  pool_[static_cast<std::size_t>(at)] = {time, ball, first};
  first = at;
  ++bucketed_;
}

void CalendarQueue::insert_into_open(double time, std::int32_t ball) {
  auto at = open_.size();
  open_.push_back({});
  for (; at > 0; --at) {
    const Entry& e = open_[at - 1];
    if (e.time > time || (e.time == time && e.ball > ball)) break;
    open_[at] = e;
  }
  open_[at] = {time, ball, -1};
}

ScheduledEvent CalendarQueue::next() {
  for (;;) {
    while (!open_.empty()) {
      const Entry& e = open_.back();
      if (!stale(e)) return {e.time, e.ball};
      open_.pop_back();
    }
    if (bucketed_ == 0 && overflow_.empty()) return {std::numeric_limits<double>::infinity(), -1};
    retune();
    open_next();
  }
}

void CalendarQueue::open_next() {
  if (bucketed_ == 0) {  // empty ring: jump to the first overflow entry
    std::int64_t first = far_away;
    for (const Entry& e : overflow_) first = std::min(first, slice_of(e.time));
    if (first == far_away) return start_at_earliest();
    slice_ = first - 1;
    refile_overflow();
  }
  ++slice_;
  if ((slice_ & (bucket_count_ - 1)) == 0) refile_overflow();
  std::int32_t& first = buckets_[static_cast<std::size_t>(slice_ & (bucket_count_ - 1))];
  for (std::int32_t at = first; at >= 0;) {
    Entry& e = pool_[static_cast<std::size_t>(at)];
    const std::int32_t next = e.next;
    if (!stale(e)) open_.push_back(e);
    ++opened_;
    e.next = free_;
    free_ = at;
    at = next;
    --bucketed_;
  }
  first = -1;
  ahead_ = buckets_[static_cast<std::size_t>((slice_ + 1) & (bucket_count_ - 1))];
  sort_open();
}

std::int32_t CalendarQueue::next_slice_ball() {
  if (ahead_ < 0) return -1;
  const Entry& e = pool_[static_cast<std::size_t>(ahead_)];
  ahead_ = e.next;
  if (ahead_ >= 0) __builtin_prefetch(&pool_[static_cast<std::size_t>(ahead_)]);
  __builtin_prefetch(&times_[static_cast<std::size_t>(e.ball)]);
  return e.ball;
}

/// Restarts at the earliest event with a new slice width: slice numbers of all remaining events
/// would overflow.
void CalendarQueue::start_at_earliest() {
  const double earliest = *std::ranges::min_element(times_);
  if (earliest == std::numeric_limits<double>::infinity()) return overflow_.clear();
  origin_ = earliest;
  start_at(rate(), earliest);
}

void CalendarQueue::refile_overflow() {
  std::vector<Entry> waiting;
  waiting.swap(overflow_);
  for (const Entry& e : waiting)
    if (!stale(e)) add_entry(slice_of(e.time), e.time, e.ball);
}

}  // namespace mahlwerk::event
