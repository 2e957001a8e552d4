// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mahlwerk/base/huge_page_allocator.hpp"

namespace mahlwerk::event {

/// What comes next: a ball and when [s].
struct ScheduledEvent {
  double time = 0;
  std::int32_t ball = -1;  ///< < 0: nothing is due at all
  bool operator==(const ScheduledEvent&) const = default;
};

/// One appointment per ball, the earliest first, ties by the ball's number.
///
/// Time is cut into slices, a bucket each, in a ring; only the slice that is open is sorted. A new
/// appointment leaves the old entry where it is: an entry whose time is no longer its ball's is
/// dropped when its slice opens. What lies beyond the ring waits in a list until the ring comes
/// round. All of it costs the same whatever the number of balls.
class CalendarQueue {
 public:
  /// Starts anew with an appointment per ball [s], infinite for none. Slices get the width that
  /// suits these.
  void start(std::span<const double> times, double now);

  void schedule(std::int32_t ball, double time);
  ScheduledEvent next();  ///< the earliest; stays until its ball is given another time
  /// Who comes after `later` others, if that is known already; < 0: it is not.
  std::int32_t upcoming(std::ptrdiff_t later) const {
    const auto place = std::ssize(open_) - 1 - later;
    return place < 0 ? -1 : open_[static_cast<std::size_t>(place)].ball;
  }
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
  void add_to_bucket(std::int64_t slice, double time, std::int32_t ball);
  void insert(double time, std::int32_t ball);
  void open_next();
  void sort_open();
  void start_at_earliest();
  void refile_overflow();
  bool stale(const Entry& e) const { return times_[static_cast<std::size_t>(e.ball)] != e.time; }

  HugePageVector<double> times_;               // [s] by ball
  HugePageVector<std::int32_t> buckets_;       // first entry of each, a ring
  HugePageVector<Entry> pool_;                 // entries of all buckets
  std::int32_t free_ = -1;                     // first unused one
  std::int64_t bucketed_ = 0;                  // entries in buckets
  std::vector<Entry> open_;                    // the open slice, the earliest last
  std::vector<Entry> overflow_;                // too late for the ring
  std::int64_t slice_ = 0, bucket_count_ = 0;  // open slice; number of buckets, a power of two
  double origin_ = 0, slices_per_second_ = 1;
  std::int64_t opened_ = 0;  // entries since the start
};

}  // namespace mahlwerk::event
