// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/restitution.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/units.hpp"

namespace mahlwerk::measure {
namespace {

constexpr double least_flight = 0.02;  // [s]
constexpr double growth = 1.05;        // of a flight that begins a new drop

InputError drop_fault(std::string what, std::string remedy) {
  return InputError(Fault{"", std::move(what), std::move(remedy), "bad-readings"});
}

void check(const std::vector<Bounce>& bounces) {
  if (bounces.size() < 3)
    throw drop_fault(
        fmt::format("there are {} impacts; at least 3 are needed for an interval", bounces.size()),
        "drop the ball five times or more");
  for (const Bounce& one : bounces)
    if (!(one.restitution > 0 && one.restitution <= 1) || !(one.speed > 0))
      throw drop_fault(fmt::format("an impact at {} has the restitution {:.3g}, which is not "
                                   "between 0 and 1",
                                   show_rounded(one.speed, "m/s", 3), one.restitution),
                       "check heights and units, and that no other sound counts as an impact: a "
                       "larger --rise hears the loud ones only");
}

/// A remark if restitution differs between slow and fast impacts beyond their scatter.
void remark_speed(std::vector<Bounce> bounces, Findings& found) {
  if (bounces.size() < 6) return;
  std::ranges::stable_sort(bounces, {}, &Bounce::speed);
  const auto half = [](auto begin, auto end) {
    std::vector<double> values;
    for (auto at = begin; at != end; ++at) values.push_back(at->restitution);
    return observe::estimate(values);
  };
  const auto middle = bounces.begin() + static_cast<std::ptrdiff_t>(bounces.size() / 2);
  const observe::Estimate slow = half(bounces.begin(), middle), fast = half(middle, bounces.end());
  if (bounces.back().speed < 1.3 * bounces.front().speed) return;
  if (std::abs(slow.mean - fast.mean) > slow.ci95 + fast.ci95)
    found.remarks.push_back(fmt::format(
        "Restitution depends on the speed: {:.3f} below and {:.3f} above {}. Drop from the height "
        "that gives the speed in your mill, or give the case a restitution_table.",
        slow.mean, fast.mean, show_rounded(middle->speed, "m/s", 3)));
}

/// A remark if the first impact, with the speed of the given height, does not fit to the later
/// ones.
void remark_height(const std::vector<Bounce>& bounces, Findings& found) {
  std::vector<double> later;
  for (const Bounce& one : bounces)
    if (!one.first) later.push_back(one.restitution);
  if (later.size() < 2 || later.size() == bounces.size()) return;
  const double mean = observe::estimate(later).mean;
  const auto off = [&](const Bounce& one) {
    return one.first && std::abs(one.restitution - mean) > 0.15 * mean;
  };
  if (const auto one = std::ranges::find_if(bounces, off); one != bounces.end())
    found.remarks.push_back(fmt::format(
        "A first impact has the restitution {:.3f}, the later ones {:.3f} in the mean: check "
        "--height, and that the recording begins with the first impact.",
        one->restitution, mean));
}

}  // namespace

Bounce bounce_of_heights(double fall, double rebound) {
  return {std::sqrt(2 * standard_gravity * fall), std::sqrt(rebound / fall), true};
}

std::vector<Bounce> bounces_of_times(const std::vector<double>& times, double height) {
  std::vector<double> flights;
  for (std::size_t i = 1; i < times.size(); ++i) {
    if (!(times[i] > times[i - 1]))
      throw drop_fault("the times of the impacts do not increase", "sort them");
    flights.push_back(times[i] - times[i - 1]);
  }
  std::vector<Bounce> made;
  const double fallen = std::sqrt(2 * standard_gravity * height);
  bool begins = true, ended = false;
  for (std::size_t i = 0; i < flights.size(); ++i) {
    const double after = 0.5 * standard_gravity * flights[i];
    if (i > 0 && flights[i] > growth * flights[i - 1]) {  // the ball is lifted for the next drop
      begins = true;
      ended = false;
      continue;
    }
    if (flights[i] < least_flight) ended = true;
    if (ended) continue;
    if (begins) {
      if (!std::isnan(height)) made.push_back({fallen, after / fallen, true});
    } else {
      const double before = 0.5 * standard_gravity * flights[i - 1];
      made.push_back({before, after / before, false});
    }
    begins = false;
  }
  if (made.empty())
    throw drop_fault(
        "no bounces follow each other",
        "record at least two bounces of a drop, or give the height, --height \"300 mm\"");
  return made;
}

Findings restitution_of(const std::vector<Bounce>& bounces) {
  std::vector<Bounce> used;
  std::ranges::copy_if(bounces, std::back_inserter(used), &Bounce::first);
  const bool first = used.size() >= 3;
  if (!first) used = bounces;
  check(used);
  std::vector<double> values, speeds;
  for (const Bounce& one : used) {
    values.push_back(one.restitution);
    speeds.push_back(one.speed);
  }
  Findings found{{{"contact.restitution", "restitution", "", observe::estimate(values)},
                  {"",
                   "speed of these impacts",
                   "m/s",
                   {observe::estimate(speeds).mean,
                    0.5 * (std::ranges::max(speeds) - std::ranges::min(speeds))}}},
                 {},
                 {}};
  found.remarks.push_back(
      first ? fmt::format("From the first impact of {} drops; later bounces hit powder that is "
                          "already pressed aside.",
                          used.size())
            : fmt::format("From {} impacts that follow each other.", used.size()));
  remark_speed(used, found);
  remark_height(bounces, found);
  return found;
}

}  // namespace mahlwerk::measure
