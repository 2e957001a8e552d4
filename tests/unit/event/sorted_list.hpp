// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <set>
#include <span>
#include <utility>
#include <vector>

#include "mahlwerk/event/calendar_queue.hpp"

namespace mahlwerk::tests {

/// Plain reference of the calendar queue: a sorted list of all scheduled events.
class SortedList {
 public:
  void start(std::span<const double> times, double /*now*/) {
    times_.assign(times.begin(), times.end());
    list_.clear();
    for (std::int32_t i = 0; i < std::ssize(times_); ++i) list_.emplace(time_of(i), i);
  }
  void schedule(std::int32_t ball, double time) {
    list_.erase({time_of(ball), ball});
    times_[static_cast<std::size_t>(ball)] = time;
    list_.emplace(time, ball);
  }
  event::ScheduledEvent next() const {
    const auto [time, ball] = *list_.begin();
    if (time == std::numeric_limits<double>::infinity()) return {time, -1};
    return {time, ball};
  }
  double time_of(std::int32_t ball) const { return times_[static_cast<std::size_t>(ball)]; }
  std::span<const double> times() const { return times_; }

 private:
  std::vector<double> times_;
  std::set<std::pair<double, std::int32_t>> list_;
};

}  // namespace mahlwerk::tests
