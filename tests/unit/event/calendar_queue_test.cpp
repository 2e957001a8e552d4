// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/calendar_queue.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "mahlwerk/base/random.hpp"
#include "sorted_list.hpp"

namespace mahlwerk::tests::calendar_queue_test {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// A calendar queue and a sorted list that receive the same operations.
class Pair {
 public:
  Pair(std::int32_t balls, std::uint64_t seed) : random_(seed, 0), balls_(balls) {
    std::vector<double> times;
    for (std::int32_t i = 0; i < balls; ++i) times.push_back(later());
    calendar_.start(times, now_);
    list_.start(times, now_);
  }

  void schedule(std::int32_t ball, double time) {
    calendar_.schedule(ball, time);
    list_.schedule(ball, time);
  }
  /// One random operation that an engine may do, or a slightly more extreme one.
  void do_something() {
    const double what = random_.uniform();
    const event::ScheduledEvent due = list_.next();
    if (what < 0.6 && due.ball >= 0) {
      now_ = due.time;
      schedule(due.ball, later());
    } else if (what < 0.8) {
      schedule(any(), later());
    } else if (what < 0.85) {
      schedule(any(), never);
    } else if (what < 0.9) {
      schedule(any(), due.time);  // two events at one time, or `never`
    } else if (what < 0.92) {
      schedule(any(), now_);
    } else if (what < 0.921) {
      const double time = later();  // a burst
      for (int i = 0; i < std::min(balls_, 100); ++i) schedule(any(), time);
    } else if (what < 0.9211) {
      const double time = random_.uniform() < 0.5 ? later() : now_;
      for (std::int32_t i = 0; i < balls_; ++i) schedule(i, time);
    } else if (what < 0.9212) {
      calendar_.start(list_.times(), now_);
    } else if (due.ball < 0) {
      schedule(any(), later());
    }
  }
  bool agree() { return calendar_.next() == list_.next(); }
  void pace(double seconds) { pace_ = seconds; }
  double now() const { return now_; }

 private:
  std::int32_t any() {
    return std::min(static_cast<std::int32_t>(random_.uniform() * balls_), balls_ - 1);
  }
  double later() { return now_ + pace_ * std::pow(10, random_.uniform(-6, 6)); }

  Random random_;
  std::int32_t balls_;
  double now_ = 0, pace_ = 1e-3;
  event::CalendarQueue calendar_;
  SortedList list_;
};

/// Intervals of milliseconds, then a million times shorter, then a million times longer.
void hold_side_by_side(std::int32_t balls, std::int64_t operations) {
  Pair pair(balls, static_cast<std::uint64_t>(balls));
  for (std::int64_t i = 0; i < operations; ++i) {
    if (i == operations / 3) pair.pace(1e-9);
    if (i == operations * 2 / 3) pair.pace(1e3);
    ASSERT_TRUE(pair.agree()) << "after " << i << " operations at " << pair.now() << " s";
    pair.do_something();
  }
}

TEST(CalendarQueue, goes_like_a_sorted_list_for_one_ball) {
  hold_side_by_side(1, 1'000'000);
}
TEST(CalendarQueue, goes_like_a_sorted_list_for_two_balls) {
  hold_side_by_side(2, 1'000'000);
}
TEST(CalendarQueue, goes_like_a_sorted_list_for_a_hundred_balls) {
  hold_side_by_side(100, 1'000'000);
}
TEST(CalendarQueue, goes_like_a_sorted_list_for_ten_thousand_balls) {
  hold_side_by_side(10'000, 1'000'000);
}

TEST(CalendarQueue, with_nothing_due_says_so) {
  event::CalendarQueue calendar;
  calendar.start(std::vector<double>{never, never}, 0);
  EXPECT_EQ(calendar.next(), (event::ScheduledEvent{never, -1}));
  calendar.schedule(1, 5);
  EXPECT_EQ(calendar.next(), (event::ScheduledEvent{5, 1}));
  calendar.schedule(1, never);
  EXPECT_EQ(calendar.next(), (event::ScheduledEvent{never, -1}));
}

/// Simultaneous events give the narrowest slices, too many of them to number up to an hour later.
TEST(CalendarQueue, an_earlier_time_after_one_beyond_all_slices_comes_first) {
  event::CalendarQueue calendar;
  calendar.start(std::vector<double>{0, 0}, 0);
  calendar.schedule(0, 1e5);
  calendar.schedule(1, 1e6);
  ASSERT_EQ(calendar.next(), (event::ScheduledEvent{1e5, 0}));  // a preview; now is still 0
  calendar.schedule(1, 1e-3);
  EXPECT_EQ(calendar.next(), (event::ScheduledEvent{1e-3, 1}));
}

}  // namespace
}  // namespace mahlwerk::tests::calendar_queue_test
