// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/flow/notices.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::flow {
namespace {

using cases::Case;
using Feed = cases::Flow::Feed;
using results::Outcome;
using results::Replicate;
using Chosen = std::vector<const Replicate*>;

constexpr double unsteady_share = 0.1, limited_share = 0.05, noise = 3;  // of the larger; sigma

template <class Of>
double sum_over(const Chosen& chosen, const Of& of) {
  double sum = 0;
  for (const Replicate* r : chosen) sum += of(*r);
  return sum;
}

/// The replicate whose fresh feed ran out first, so that nothing entered at the end of it.
Notices exhausted(const Chosen& chosen) {
  const Replicate* first = nullptr;
  for (const Replicate* r : chosen)
    if (const auto at = record_of(*r).exhausted();
        at && r->energy_balance.time - *at > 0.01 * r->time() &&
        (first == nullptr || *at < *record_of(*first).exhausted()))
      first = r;
  if (first == nullptr) return {};
  const double at = *record_of(*first).exhausted(), counted = at - record_of(*first).begin();
  const std::string when =
      counted < 0 ? fmt::format("{} before counting began", show_rounded(-counted, "s"))
                  : fmt::format("{} after counting began", show_rounded(counted, "s"));
  return {warning(
      "feed-exhausted",
      fmt::format(
          "The fresh feed was used up {} after the start of the run, {}: nothing has "
          "entered since then, and the jar empties. Give more balls of the sets of "
          "fresh_feed, a lower feed_rate or a shorter run.time; or write recirculate = true.",
          show_rounded(at, "s"), when))};
}

/// The feed that was asked for while balls waited: [1] by number or [kg] by mass.
double asked(const Case& c, double busy_time) {
  return c.flow->feed_mass_rate.value_or(c.flow->feed_rate) * busy_time;
}
double entered(const Case& c, const Replicate& r) {
  const Amount all = record_of(r).all().entered;
  return c.flow->feed_mass_rate ? all.mass : all.count;
}

/// Balls that wait at a given rate enter at this rate, unless they find no room.
Notices limited_rate(const Case& c, const Chosen& chosen) {
  const double wanted = sum_over(chosen, [&](const Replicate& r) {
    return asked(c, record_of(r).queue(r.energy_balance.time).busy_time);
  });
  const double found = sum_over(chosen, [&](const Replicate& r) { return entered(c, r); });
  const double counted =
      sum_over(chosen, [](const Replicate& r) { return record_of(r).all().entered.count; });
  const double balls =
      found > 0 ? (wanted - found) * counted / found : 2 * noise;  // that are lacking
  if (!(wanted - found > limited_share * wanted) || balls < noise) return {};
  return {
      warning("inlet-limits-flow",
              fmt::format("The inlet limits the feed: {:.0f} % of what was asked for entered, the "
                          "rest found no room in its box. Give a larger inlet_size, move the "
                          "inlet to where balls fall away from it, or ask for less.",
                          100 * found / wanted))};
}

/// Balls that recirculate enter at once, unless they find no room.
Notices limited_circulation(const Chosen& chosen) {
  const auto mean = [&](const auto& of) {
    return sum_over(chosen, of) / static_cast<double>(chosen.size());
  };
  const auto queue = [](const Replicate& r) { return record_of(r).queue(r.energy_balance.time); };
  const double waiting = mean([&](const Replicate& r) { return queue(r).mean; });
  const double busy =
      mean([&](const Replicate& r) { return results::share(queue(r).busy_time, r.time()); });
  const double inside = mean(
      [](const Replicate& r) { return record_of(r).mean_inside(r.energy_balance.time).count; });
  constexpr double few = 0.01;  // of those inside
  if (!(busy > limited_share) || !(waiting > few * inside)) return {};
  return {
      warning("inlet-limits-flow",
              fmt::format("The inlet limits the flow: for {:.0f} % of the counted time balls "
                          "waited for room in its box, {:.3g} of them on average. Give a larger "
                          "inlet_size, or move the inlet to where balls fall away from it.",
                          100 * busy, waiting))};
}

Notices limited(const Case& c, const Chosen& chosen) {
  if (c.flow->feed == Feed::rate) return limited_rate(c, chosen);
  return c.flow->feed == Feed::recirculate ? limited_circulation(chosen) : Notices();
}

/// More or fewer balls enter than leave, beyond chance.
Notices unsteady(const Chosen& chosen) {
  const double left =
      sum_over(chosen, [](const Replicate& r) { return record_of(r).all().left.count; });
  const double in =
      sum_over(chosen, [](const Replicate& r) { return record_of(r).all().entered.count; });
  const double change = std::abs(in - left), most = std::max(in, left);
  if (!(change > unsteady_share * most) || !(change > noise * std::sqrt(most))) return {};
  return {warning("flow-not-steady",
                  fmt::format("The jar {}: while it was counted, {:.0f} balls entered and {:.0f} "
                              "left. holdup and residence_time are not those of the steady state. "
                              "A longer run.settle tells; flow.csv has the numbers over time.",
                              in > left ? "fills" : "empties", in, left))};
}

Notices short_for_residence(const Chosen& chosen) {
  const bool unknown = std::ranges::any_of(
      chosen, [](const Replicate* r) { return !std::isfinite(of_tracers(*r).mean); });
  if (!unknown) return {};
  return {warning("short-for-residence",
                  "The counted time is too short for the spread of the residence times: more "
                  "than 5 % of the balls that entered stayed longer than any was followed. A "
                  "longer run.time tells.")};
}

}  // namespace

Notices notices(const Outcome& outcome) {
  const Case& c = outcome.mill_case;
  const Chosen chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return {};
  const bool fed = is_fed(c);
  Notices all = fed ? exhausted(chosen) : Notices();
  const bool over = !all.empty();
  append(all, fed ? limited(c, chosen) : Notices());
  if (sum_over(chosen, [](const Replicate& r) { return record_of(r).all().left.count; }) == 0) {
    all.push_back(warning("nothing-left",
                          "No ball left the jar while it was counted: none came to the outlet, the "
                          "opening is blocked, or run.time is too short."));
    return all;
  }
  if (!fed) return all;
  append(all, over ? Notices() : unsteady(chosen));
  append(all, short_for_residence(chosen));
  return all;
}

}  // namespace mahlwerk::parts::flow
