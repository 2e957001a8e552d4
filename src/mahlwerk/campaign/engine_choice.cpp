// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/engine_choice.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/replicate.hpp"

namespace mahlwerk::campaign {
namespace {

struct Nobody final : scene::Observer {
  void collisions(std::span<const scene::Collision>) override {}
};

double balls(const cases::Case& what) {
  double count = 0;
  for (const cases::BallSet& set : what.balls) count += static_cast<double>(set.count);
  return count;
}

double contact_share(const scene::Account& from, const scene::Account& to, double balls) {
  const double time = (to.time - from.time) * balls;
  return time > 0 ? (to.contact_time - from.contact_time) / time : 0;
}

std::string percent(double share) {
  return fmt::format("{:.0f} %", 100 * share);
}

constexpr std::string_view soft_is_missing =
    "For such a charge the soft engine is advised; it is not part of this version. Power and dose "
    "are sound; the number of hits, and forces inside the bed, depend on contact.contact_time.";

/// Of the balls' time, over all replicates.
double contact_share(const results::Outcome& outcome) {
  double time = 0, contact = 0;
  for (const results::Replicate& r : outcome.replicates) {
    time += r.time() * balls(outcome.what);
    contact += r.account.contact_time - r.at_settled.contact_time;
  }
  return time > 0 ? contact / time : 0;
}

}  // namespace

Pilot pilot(const cases::Case& what) {
  constexpr int parts = 100;
  constexpr std::int64_t enough = 400'000;  // collisions: half a second or so of work
  const double whole = std::min(1.0, what.run.settle + what.run.time);
  const auto trial = engine(what, 0);
  Nobody nobody;
  std::vector<scene::Account> seen{trial->account()};
  try {
    for (int i = 1; i <= parts && seen.back().collisions < enough; ++i) {
      trial->advance(whole * i / parts, nobody);
      seen.push_back(trial->account());
    }
  } catch (const RunError&) {  // the run itself will say so
  }
  const scene::Account &middle = seen[seen.size() / 2], &end = seen.back();
  return {end.time, contact_share(middle, end, balls(what))};
}

std::vector<std::string> notes_on(const results::Outcome& outcome) {
  const cases::Case& what = outcome.what;
  const bool chosen = what.run.engine == "auto";
  if (balls(what) == 1) {
    if (!chosen) return {};
    return {"Engine: event, chosen by auto. One ball flies, bounces, rolls and slides exactly."};
  }
  const double share = contact_share(outcome);
  if (!chosen) {
    if (share <= most_contact) return {};
    return {fmt::format("The balls were in contact {} of the time. {}", percent(share),
                        soft_is_missing)};
  }
  const Pilot p = pilot(what);
  return {fmt::format(
      "Engine: event, chosen by auto. In a pilot run of {:.3g} s the balls were in contact {} of "
      "the "
      "time, in the run itself {}. {}",
      p.time, percent(p.share), percent(share),
      std::max(p.share, share) > most_contact
          ? std::string(soft_is_missing)
          : fmt::format("Up to {} the event engine is advised.", percent(most_contact)))};
}

}  // namespace mahlwerk::campaign
