// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/paper/representatives.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

/// The regime of one replicate alone.
std::string regime_of(const Outcome& outcome, const Replicate& replicate) {
  Outcome alone;
  alone.mill_case = outcome.mill_case;
  alone.engine = outcome.engine;
  alone.replicates = {replicate};
  return results::regime(alone);
}

void add(std::vector<ReplicateGroup>& groups, const std::string& state, const Replicate* member) {
  auto group = std::ranges::find(groups, state, &ReplicateGroup::state);
  if (group == groups.end()) group = groups.insert(groups.end(), {state, {}});
  group->members.push_back(member);
}

std::vector<ReplicateGroup> groups_of(const Outcome& outcome,
                                      const std::vector<const Replicate*>& all) {
  std::vector<ReplicateGroup> groups;
  for (const Replicate* r : all) add(groups, regime_of(outcome, *r), r);
  if (groups.size() > 1 || !outcome.summary.two_states) return groups;
  const std::string regime = groups.empty() ? "" : groups.front().state;
  groups.clear();
  const std::vector<std::size_t>& low = outcome.summary.two_states->states[0].replicates;
  for (const Replicate* r : all) {
    const bool is_low = std::ranges::find(low, results::number_of(outcome, *r)) != low.end();
    add(groups,
        fmt::format("{}{} power", regime.empty() ? "" : regime + ", ", is_low ? "low" : "high"), r);
  }
  return groups;
}

double speed_of(const Outcome& outcome, const Replicate& replicate) {
  if (outcome.summary.by_replicate.size() < outcome.replicates.size()) return NAN;
  const double speed = results::value_of(outcome, replicate, "ball_speed_seen_from_carrier");
  return std::isfinite(speed) ? speed : results::value_of(outcome, replicate, "dissipated_power");
}

/// The replicate with the median speed; replicates without speed count as fastest.
const Replicate* median_of(const Outcome& outcome, std::vector<const Replicate*> members) {
  std::ranges::stable_sort(members, {}, [&](const Replicate* r) {
    const double speed = speed_of(outcome, *r);
    return std::isnan(speed) ? INFINITY : speed;
  });
  return members[(members.size() - 1) / 2];
}

}  // namespace

std::vector<Representative> representatives(const Outcome& outcome) {
  std::vector<const Replicate*> all = results::averaged_replicates(outcome);
  if (all.empty())
    for (const Replicate& r : outcome.replicates) all.push_back(&r);
  std::vector<ReplicateGroup> groups = groups_of(outcome, all);
  std::ranges::stable_sort(groups, std::greater{},
                           [](const ReplicateGroup& g) { return g.members.size(); });
  std::vector<Representative> list;
  for (const ReplicateGroup& group : groups) {
    const std::size_t number = results::number_of(outcome, *median_of(outcome, group.members));
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
