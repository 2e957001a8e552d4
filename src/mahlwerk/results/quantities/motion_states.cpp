// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/motion_states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using observe::Estimate;
using observe::MotionState;
using observe::MotionTotals;

using Total = double MotionTotals::*;

template <MotionState state>
double share_of_balls(const Case&, const Replicate& r) {
  return share(r.motion.time_of_balls(state), r.motion.time_of_balls());
}

/// Sum over all states.
double total(const Replicate& r, Total of) {
  double all = 0;
  for (const MotionState state : observe::all_motion_states) all += r.motion.in(state).*of;
  return all;
}

double changes_per_second(const Case&, const Replicate& r) {
  std::int64_t visits = 0;
  for (const MotionState state : observe::all_motion_states) visits += r.motion.visits(state);
  return share(static_cast<double>(std::max<std::int64_t>(0, visits - 1)), r.motion.time());
}

double turns(const Case&, const Replicate& r) {
  return share(total(r, &MotionTotals::turned), total(r, &MotionTotals::time));
}
double axial_ratio(const Case&, const Replicate& r) {
  return share(total(r, &MotionTotals::axial_ratio), total(r, &MotionTotals::time));
}

/// The sum in the state; of energies lost only what is more than rounding.
double sum_of(const Replicate& r, MotionState state, Total of) {
  const double sum = r.motion.in(state).*of;
  return of == &MotionTotals::lost ? above_rounding(r, sum) : sum;
}

/// Sum of `of` over that of `over`, in the state, over the replicates; with its half-width
/// (obs.21).
Estimate ratio(const std::vector<const Replicate*>& replicates, MotionState state, Total of,
               Total over) {
  double sum = 0, whole = 0, squares = 0;
  int having = 0;
  for (const Replicate* r : replicates) {
    sum += sum_of(*r, state, of);
    whole += r->motion.in(state).*over;
    having += r->motion.in(state).*over > 0 ? 1 : 0;
  }
  if (!(whole > 0)) return {};
  Estimate found{.mean = sum / whole};
  for (const Replicate* r : replicates) {
    const double off = sum_of(*r, state, of) - found.mean * r->motion.in(state).*over;
    squares += off * off;
  }
  const auto n = static_cast<double>(replicates.size());
  if (having > 1)
    found.ci95 =
        observe::student95(static_cast<int>(n) - 1) * std::sqrt(n / (n - 1) * squares) / whole;
  return found;
}

Estimate share_of_time(const std::vector<const Replicate*>& replicates, MotionState state) {
  std::vector<double> each;
  for (const Replicate* r : replicates)
    if (r->motion.time() > 0) each.push_back(r->motion.in(state).time / r->motion.time());
  return observe::estimate(each);
}

MotionStateSummary summary_of(const std::vector<const Replicate*>& replicates, MotionState state) {
  MotionStateSummary made;
  made.name = name_of(state);
  made.share = share_of_time(replicates, state);
  double time = 0, visits = 0;
  for (const Replicate* r : replicates) {
    time += r->motion.in(state).time;
    visits += static_cast<double>(r->motion.visits(state));
    made.replicates += r->motion.in(state).time > 0 ? 1 : 0;
  }
  made.visit = share(time, visits);
  made.power = ratio(replicates, state, &MotionTotals::lost, &MotionTotals::time);
  made.hit_rate = ratio(replicates, state, &MotionTotals::hits, &MotionTotals::time);
  made.hit_energy = ratio(replicates, state, &MotionTotals::energy, &MotionTotals::hits);
  made.turns = ratio(replicates, state, &MotionTotals::turned, &MotionTotals::time);
  made.axial_ratio = ratio(replicates, state, &MotionTotals::axial_ratio, &MotionTotals::time);
  return made;
}

/// The states of these replicates with at least `least` of their time, the longest first.
std::vector<MotionStateSummary> states_of(const std::vector<const Replicate*>& replicates,
                                          double least) {
  std::vector<MotionStateSummary> found;
  for (const MotionState state : observe::all_motion_states)
    if (auto one = summary_of(replicates, state); one.share.mean >= least)
      found.push_back(std::move(one));
  std::ranges::stable_sort(found, std::ranges::greater(),
                           [](const MotionStateSummary& s) { return s.share.mean; });
  return found;
}

std::string words(const MotionStateSummary& s) {
  return fmt::format("{} for {:.0f} % of the time ({}, {} hits)", s.name, 100 * s.share.mean,
                     show_rounded(s.power.mean, "W"), show_rounded(s.hit_rate.mean, "1/s"));
}

bool differ(double a, double b) {
  constexpr double much = 0.2;
  return std::abs(a - b) > much * std::max(std::abs(a), std::abs(b));
}

}  // namespace

bool has_motion_states(const Case& c) {
  return knows_losses(c) && c.mill.speed_over_time.empty() &&
         observe::has_motion_states(*c.mill.motion, *c.jar.shape, c.mill.jar_axis);
}

Measures motion_state_measures() {
  return where(
      has_motion_states, "lying jars that are shaken",
      {{"circling_share",
        "1",
        "share of the balls' time, by periods of the mill, in which they go round the jar's axis",
        share_of_balls<MotionState::circling>,
        {.range = share_of_whole, .equation = "obs.20", .heading = "Motion of the charge"}},
       {"bouncing_share",
        "1",
        "share of the balls' time, by periods of the mill, in which they go from end to end of the "
        "jar",
        share_of_balls<MotionState::bouncing>,
        {.range = share_of_whole, .equation = "obs.20"}},
       {"pinned_share",
        "1",
        "share of the balls' time, by periods of the mill, in which they move with the jar",
        share_of_balls<MotionState::pinned>,
        {.range = share_of_whole, .equation = "obs.20"}},
       {"stationary_share",
        "1",
        "share of the balls' time, by periods of the mill, in which they stay where they are while "
        "the jar moves under them",
        share_of_balls<MotionState::stationary>,
        {.range = share_of_whole, .equation = "obs.20"}},
       {"state_changes",
        "1/s",
        "changes of the charge from one state of motion to another, per second",
        changes_per_second,
        {.equation = "obs.20"}},
       {"turns_per_cycle",
        "1",
        "turns of a ball round the jar's axis in a period of the mill, in either sense",
        turns,
        {.equation = "obs.20"}},
       {"axial_ratio",
        "1",
        "travel of a ball along the jar's axis in a period, seen from the laboratory, over that of "
        "the jar",
        axial_ratio,
        {.equation = "obs.20"}}});
}

std::vector<MotionStateSummary> motion_states(const Outcome& outcome) {
  constexpr double least = 0.01;
  if (!has_motion_states(outcome.mill_case)) return {};
  return states_of(averaged_replicates(outcome), least);
}

std::string motion_word(const std::vector<const Replicate*>& replicates) {
  constexpr double least = 0.1;
  std::string text;
  for (const MotionStateSummary& s : states_of(replicates, least))
    text += (text.empty() ? "" : " and ") + s.name;
  return text;
}

std::string motion_reason(const std::vector<MotionStateSummary>& states) {
  std::string text;
  for (const MotionStateSummary& s : states)
    text += fmt::format(
        "{}{} for {:.0f} % of the time, with {:.2g} turns round the jar's axis in a "
        "period",
        text.empty() ? "" : "; ", s.name, 100 * s.share.mean, s.turns.mean);
  return text;
}

Notices motion_state_notices(const Outcome& outcome) {
  const Summary& summary = outcome.summary;
  constexpr double least = 0.05;
  std::vector<const MotionStateSummary*> found;
  for (const MotionStateSummary& s : summary.motion_states)
    if (s.share.mean >= least) found.push_back(&s);
  const auto other = [&](const MotionStateSummary* s) {
    return differ(s->power.mean, found.front()->power.mean) ||
           differ(s->hit_rate.mean, found.front()->hit_rate.mean);
  };
  if (found.size() < 2 || std::ranges::none_of(found, other)) return {};
  std::string text;
  for (const MotionStateSummary* s : found) text += (text.empty() ? "" : ", ") + words(*s);
  const bool changes = named(summary.quantities, "state_changes").value > 0;
  constexpr std::string_view ramp = " run.start = \"ramp\" starts the mill as a motor does.";
  const bool ramped = outcome.mill_case.run.start == cases::StartLayout::ramp;
  const std::string why =
      changes
          ? "It changes between them by itself: a longer run.time gives their shares of the time "
            "better."
          : fmt::format("No replicate changes between them: the start decides.{}",
                        ramped ? "" : ramp);
  return {warning("motion-states",
                  fmt::format("The charge is {}. Power and hits of the result are means over these "
                              "states. {}",
                              text, why))};
}

}  // namespace mahlwerk::results
