// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/representatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/observe/groups.hpp"
#include "mahlwerk/results/quantities/regime.hpp"

namespace mahlwerk::report {
namespace {

using results::Outcome;
using results::Replicate;

/// Replicates in the same state of motion.
struct ReplicateGroup {
  std::string state;
  std::vector<const Replicate*> members;
};

void add(std::vector<ReplicateGroup>& groups, const std::string& state, const Replicate* member) {
  auto group = std::ranges::find(groups, state, &ReplicateGroup::state);
  if (group == groups.end()) group = groups.insert(groups.end(), {state, {}});
  group->members.push_back(member);
}

/// The number that orders replicates: the speed of the balls, where there is none the dissipated
/// power.
struct MotionNumbers {
  bool speeds = false;
  std::vector<double> of;  // by replicate of the outcome; NaN where there is none
};

MotionNumbers motion_numbers(const Outcome& outcome) {
  MotionNumbers made;
  if (outcome.summary.by_replicate.size() < outcome.replicates.size()) {
    made.of.assign(outcome.replicates.size(), NAN);
    return made;
  }
  for (const char* quantity : {"ball_speed_seen_from_carrier", "dissipated_power"}) {
    made.of.clear();
    for (const Replicate& r : outcome.replicates)
      made.of.push_back(results::value_of(outcome, r, quantity));
    made.speeds = quantity == std::string_view("ball_speed_seen_from_carrier");
    if (std::ranges::any_of(made.of, [](double v) { return std::isfinite(v); })) break;
  }
  return made;
}

double number_in(const MotionNumbers& numbers, const Outcome& outcome, const Replicate& r) {
  return numbers.of[results::number_of(outcome, r) - 1];
}

/// Two groups by the number, if they are significant (sta.7) and differ by a fifth.
std::vector<ReplicateGroup> split(const Outcome& outcome, const std::vector<const Replicate*>& all,
                                  const MotionNumbers& numbers, const std::string& regime) {
  std::vector<double> values;
  for (const Replicate* r : all) values.push_back(number_in(numbers, outcome, *r));
  if (!std::ranges::all_of(values, [](double v) { return std::isfinite(v); })) return {};
  const auto found = observe::two_groups(values);
  if (!found) return {};
  double highest_low = -HUGE_VAL, lowest_high = HUGE_VAL;
  for (const double v : values)
    if (v > found->between)
      lowest_high = std::min(lowest_high, v);
    else
      highest_low = std::max(highest_low, v);
  constexpr double much = 0.2;
  if (!(lowest_high - highest_low > much * std::abs(lowest_high))) return {};
  std::vector<ReplicateGroup> groups;
  for (std::size_t i = 0; i < all.size(); ++i)
    add(groups,
        fmt::format("{}{} {}", regime.empty() ? "" : regime + ", ",
                    values[i] > found->between ? "high" : "low",
                    numbers.speeds ? "speed" : "power"),
        all[i]);
  return groups;
}

std::vector<ReplicateGroup> groups_of(const Outcome& outcome,
                                      const std::vector<const Replicate*>& all,
                                      const MotionNumbers& numbers) {
  std::vector<ReplicateGroup> groups;
  for (const Replicate* r : all) add(groups, results::regime(outcome.mill_case, *r), r);
  if (groups.size() != 1) return groups;
  std::vector<ReplicateGroup> two = split(outcome, all, numbers, groups.front().state);
  return two.empty() ? groups : two;
}

/// The replicate with the median speed; replicates without speed count as fastest.
const Replicate* median_of(const Outcome& outcome, std::vector<const Replicate*> members,
                           const MotionNumbers& numbers) {
  std::ranges::stable_sort(members, {}, [&](const Replicate* r) {
    const double speed = number_in(numbers, outcome, *r);
    return std::isnan(speed) ? INFINITY : speed;
  });
  return members[(members.size() - 1) / 2];
}

}  // namespace

std::vector<Representative> representatives(const Outcome& outcome) {
  std::vector<const Replicate*> all = results::averaged_replicates(outcome);
  if (all.empty())
    for (const Replicate& r : outcome.replicates) all.push_back(&r);
  const MotionNumbers numbers = motion_numbers(outcome);
  std::vector<ReplicateGroup> groups = groups_of(outcome, all, numbers);
  std::ranges::stable_sort(groups, std::greater{},
                           [](const ReplicateGroup& g) { return g.members.size(); });
  std::vector<Representative> list;
  for (const ReplicateGroup& group : groups) {
    const std::size_t number =
        results::number_of(outcome, *median_of(outcome, group.members, numbers));
    std::string words = group.state;
    if (groups.size() > 1)
      words += fmt::format("{}{} of {} replicates", words.empty() ? "" : ", ", group.members.size(),
                           all.size());
    else if (outcome.replicates.size() > 1)
      words += fmt::format("{}replicate {} of {}", words.empty() ? "" : ", ", number,
                           outcome.replicates.size());
    list.push_back({number - 1, std::move(words)});
  }
  return list;
}

}  // namespace mahlwerk::report
