// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/pilot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::campaign {
namespace {

/// Counts hits, and stops the engine after enough collisions or when the user asks for it: wedged
/// balls may collide millions of times in a short time.
struct HitCounter final : scene::Observer {
  HitCounter(double least, std::int64_t collisions, const std::atomic<bool>* user)
      : threshold(least), left(collisions), stop(user) {}
  void collisions(std::span<const scene::Collision> finished) override {
    for (const scene::Collision& c : finished)
      if (c.approach >= threshold) ++hits, energy += c.energy_normal();
    left -= std::ssize(finished);
    if (left <= 0 || (stop != nullptr && *stop)) enough = true;
  }
  double threshold;
  std::int64_t left, hits = 0;
  double energy = 0;  // [J] of the hits
  const std::atomic<bool>* stop;
  std::atomic<bool> enough = false;
};

/// State of the pilot run at the end of one of its parts.
struct Sample {
  scene::EnergyBalance energy_balance;
  std::int64_t hits = 0;
  double energy = 0;  // [J] of the hits
};

template <class Value>
observe::Estimate estimate(const std::vector<Sample>& samples, const Value& value) {
  std::vector<double> rates;
  for (std::size_t i = 1; i < samples.size(); ++i)
    rates.push_back((value(samples[i]) - value(samples[i - 1])) /
                    (samples[i].energy_balance.time - samples[i - 1].energy_balance.time));
  if (rates.empty()) return {0, std::numeric_limits<double>::quiet_NaN()};
  return observe::time_series_estimate(rates);
}

observe::Estimate change(const observe::Estimate& with, const observe::Estimate& shorter) {
  const double ratio = shorter.mean / with.mean;
  return {ratio - 1, ratio * math::hypot(with.ci95 / with.mean, shorter.ci95 / shorter.mean)};
}

/// Change of a ratio from the changes of its parts.
observe::Estimate quotient(const observe::Estimate& of, const observe::Estimate& over) {
  const double ratio = (1 + of.mean) / (1 + over.mean);
  return {ratio - 1, ratio * math::hypot(of.ci95 / (1 + of.mean), over.ci95 / (1 + over.mean))};
}

std::string change_in_words(const observe::Estimate& change) {
  if (!std::isfinite(change.mean) || !std::isfinite(change.ci95)) return "an unknown amount";
  return fmt::format("{:+.2g} % (± {:.2g} %)", 100 * change.mean, 100 * change.ci95);
}

}  // namespace

Pilot pilot(const cases::Case& mill_case, const std::atomic<bool>* stop, std::int64_t most,
            double time) try {
  constexpr int parts = 400;
  const double whole = std::min(time, cases::simulated_time(mill_case));
  const auto trial = engine(mill_case, 0, 1, stop);
  HitCounter counter(mill_case.observe.threshold, most, stop);
  trial->stop_on(&counter.enough);
  std::vector<Sample> samples{{trial->energy_balance(), 0, 0}};
  Pilot seen;
  try {
    for (int i = 1; i <= parts && !counter.enough; ++i) {
      trial->advance(whole * i / parts, counter);
      const scene::EnergyBalance now = trial->energy_balance();
      if (now.time > samples.back().energy_balance.time)
        samples.push_back({now, counter.hits, counter.energy});
      if (now.collisions >= most) break;  // many bounces may be one record (man.9)
    }
  } catch (const RunError&) {  // the samples so far are used
    seen.stopped = true;
  }
  samples.erase(samples.begin(), samples.begin() + std::ssize(samples) / 2);
  const scene::EnergyBalance &middle = samples.front().energy_balance,
                             &end = samples.back().energy_balance;
  const double of_balls = (end.time - middle.time) * static_cast<double>(trial->balls().size());
  const double lost = end.lost() - middle.lost();
  seen.time = end.time;
  if (of_balls > 0) seen.contact_share = (end.contact_time - middle.contact_time) / of_balls;
  if (lost > 0) seen.withheld_share = (end.withheld - middle.withheld) / lost;
  const std::int64_t hits = samples.back().hits - samples.front().hits;
  if (hits > 0)
    seen.hits_within =
        static_cast<double>(end.hits_within - middle.hits_within) / static_cast<double>(hits);
  seen.power = estimate(samples, [](const Sample& s) { return s.energy_balance.lost(); });
  seen.hits = estimate(samples, [](const Sample& s) { return static_cast<double>(s.hits); });
  seen.hit_power = estimate(samples, [](const Sample& s) { return s.energy; });
  return seen;
} catch (const Interrupted&) {  // while balls were placed: no result
  return {};
}

ContactTimeEffect contact_time_effect(const cases::Case& mill_case, const std::atomic<bool>* stop,
                                      std::int64_t most) {
  cases::Case shorter = mill_case;
  shorter.contact.contact_time *= ContactTimeEffect::shorter;
  const Pilot first = pilot(mill_case, stop, most),
              second = pilot(shorter, stop, 4 * most, first.time);
  const observe::Estimate hits = change(first.hits, second.hits);
  return {change(first.power, second.power), hits,
          quotient(change(first.hit_power, second.hit_power), hits)};
}

std::string in_words(const ContactTimeEffect& effect, const cases::Case& mill_case) {
  return fmt::format(
      "With a contact.contact_time of {:.3g} us instead of {:.3g} us the power of a pilot run "
      "changes by {}, the number of its hits above the threshold by {}, their mean energy by {}.",
      1e6 * mill_case.contact.contact_time * ContactTimeEffect::shorter,
      1e6 * mill_case.contact.contact_time, change_in_words(effect.power),
      change_in_words(effect.hits), change_in_words(effect.energy));
}

}  // namespace mahlwerk::campaign
