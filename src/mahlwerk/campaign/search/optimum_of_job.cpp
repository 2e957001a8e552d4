// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a search has found, in the words of its case.
#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/campaign/points/plan.hpp"
#include "mahlwerk/campaign/search/search_job.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double clearly_best = 0.995;  // probability of being the best setting tried

void describe_key(const SearchJob& job, const Optimum& found, std::size_t key, KeyOptimum& k) {
  const cases::SweptKey& range = job.runs->ranges()[key];
  constexpr int digits = 4;
  const auto text = [&](double position) { return value_in_range(range, position, digits); };
  k.key = range.key;
  k.unit = unit_of_range(range);
  k.logarithmic = range.logarithmic;
  k.text.from = range.values[0];
  k.text.to = range.values[1];
  if (!found.model_point.empty()) {
    k.text.model = job.runs->values(found.model_point)[key];
    k.text.low = text(k.low);
    k.text.high = text(k.high);
    k.text.good_low = text(k.good_low);
    k.text.good_high = text(k.good_high);
  }
  if (found.best) k.text.best = found.trials[*found.best].values[key];
  for (std::size_t i = 0; i < k.slice.size(); ++i) {
    const double position = static_cast<double>(i) / static_cast<double>(k.slice.size() - 1);
    const double from = number_in(range.values[0], k.unit);
    const double to = number_in(range.values[1], k.unit);
    k.x.push_back(range.logarithmic ? from * math::pow(to / from, position)
                                    : std::lerp(from, to, position));
  }
}

void describe_trial(const SearchJob& job, Trial& tried) {
  tried.values = job.runs->values(tried.point);
  for (std::size_t i = 0; i < tried.values.size(); ++i)
    tried.x.push_back(number_in(tried.values[i], unit_of_range(job.runs->ranges()[i])));
}

}  // namespace

std::string KeyOptimum::range_text() const {
  if (text.low != text.high) return text.low + " to " + text.high;
  return at_low_end || at_high_end ? "at the end of its range" : text.low;
}

bool Trial::invalid() const {
  return std::ranges::find(notices, Severity::invalid, &Notice::severity) != notices.end();
}

observe::Estimate Trial::outcome(std::size_t number) const {
  return number < observed.size() ? observed[number] : observe::Estimate{};
}

int Optimum::runs() const {
  std::size_t sum = 0;
  for (const Trial& t : trials) sum += t.replicates.size();
  return static_cast<int>(sum);
}

bool Optimum::certain() const {
  return best && trials[*best].probability_best > clearly_best && !trials[*best].invalid();
}

bool Optimum::disagrees() const {
  if (!best || !check || !check->failure.empty()) return false;
  const observe::Estimate own = trials[*best].outcome(0), &other = check->value;
  const double apart = std::abs(own.mean - other.mean);
  if (std::isfinite(own.ci95) && std::isfinite(other.ci95)) return apart > own.ci95 + other.ci95;
  constexpr double much = 0.1;  // of the value, if there is no interval
  return apart > much * std::abs(other.mean);
}

Optimum optimise(const SearchJob& job, const Simulation& run) {
  Optimum found = optimise(job.goal, run);
  found.title = job.runs->base().title;
  found.case_file = job.runs->base().file;
  found.outcome = job.outcomes.front();
  for (Trial& tried : found.trials) {
    describe_trial(job, tried);
    results::count(found.notices, tried.notices);
  }
  results::sort(found.notices);
  for (std::size_t key = 0; key < found.keys.size(); ++key)
    describe_key(job, found, key, found.keys[key]);
  for (std::size_t i = 0; i < job.limits.size(); ++i) {
    found.limits[i].quantity = job.limits[i].quantity;
    found.limits[i].unit = job.outcomes[i + 1].unit;
    found.limits[i].text = (job.limits[i].below ? "below " : "above ") + job.limits[i].bound;
  }
  return found;
}

}  // namespace mahlwerk::campaign
