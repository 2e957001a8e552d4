// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/huge_page_allocator.hpp"

namespace mahlwerk::event {

/// The next event: a ball and its time [s].
struct ScheduledEvent {
  double time = 0;
  std::int32_t ball = -1;  ///< < 0: there is no event
  bool operator==(const ScheduledEvent&) const = default;
};

/// Calendar queue with one event per ball, the earliest first, ties by ball number.
///
/// Time is divided into slices. Each slice has a bucket in a ring; only the open slice is sorted.
/// Rescheduling a ball leaves its old entry in place (lazy deletion): an entry whose time differs
/// from its ball's time is stale and is dropped when the queue reaches it. Entries beyond the ring
/// wait in an overflow list until the ring has gone round. The cost per operation does not depend
/// on the number of balls.
class CalendarQueue {
 public:
  /// Restarts with one event time per ball [s], infinite for none; `now` [s] is the present time.
  /// The slice width follows from these times.
  void start(std::span<const double> times, double now);

  void schedule(std::int32_t ball, double time);
  ScheduledEvent next();  ///< the earliest; stays until its ball is rescheduled
  /// Ball of the event `later` places after the earliest, if it is sorted already; else < 0.
  std::int32_t upcoming(std::ptrdiff_t later) const {
    const auto place = std::ssize(open_) - 1 - later;
    return place < 0 ? -1 : open_[static_cast<std::size_t>(place)].ball;
  }
  /// Ball of one entry of the next slice, another at each call; < 0 if there is none left. Its
  /// event may be obsolete. For prefetching: entries of a slice are scattered in memory.
  std::int32_t next_slice_ball();
  double time_of(std::int32_t ball) const { return times_[static_cast<std::size_t>(ball)]; }
  std::span<const double> times() const { return times_; }

 private:
  struct Entry {
    double time;
    std::int32_t ball, next;
  };

  std::int64_t slice_of(double time) const;
  double rate() const;
  void start_at(double rate, double now);
  void retune();
  void add_entry(std::int64_t slice, double time, std::int32_t ball);
  void insert_into_open(double time, std::int32_t ball);
  void open_next();
  void sort_open();
  void start_at_earliest();
  void refile_overflow();
  bool stale(const Entry& e) const { return times_[static_cast<std::size_t>(e.ball)] != e.time; }

  HugePageVector<double> times_;               // [s] by ball
  HugePageVector<std::int32_t> buckets_;       // first entry of each, a ring
  HugePageVector<Entry> pool_;                 // entries of all buckets
  std::int32_t free_ = -1;                     // first unused entry of the pool
  std::int32_t ahead_ = -1;                    // next entry of the next slice for next_slice_ball()
  std::int64_t bucketed_ = 0;                  // entries in buckets
  std::vector<Entry> open_;                    // the open slice, the earliest last
  std::vector<Entry> overflow_;                // too late for the ring
  std::int64_t slice_ = 0, bucket_count_ = 0;  // open slice; number of buckets, a power of two
  double origin_ = 0, slices_per_second_ = 1;
  std::int64_t opened_ = 0;  // entries opened since the start
};

}  // namespace mahlwerk::event
