// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/summarise.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "mahlwerk/cases/reversal.hpp"
#include "mahlwerk/results/quantities/means.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/motion_states.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/part_loads.hpp"
#include "mahlwerk/results/quantities/regime.hpp"
#include "mahlwerk/results/quantities/series.hpp"
#include "mahlwerk/results/quantities/states.hpp"

namespace mahlwerk::results {
namespace {

std::vector<double> values_of(const std::vector<Measure>& measures, const cases::Case& mill_case,
                              const Replicate& replicate) {
  if (replicate.read_before) return replicate.read_before->values;
  std::vector<double> values;
  for (const Measure& m : measures) values.push_back(m.compute(mill_case, replicate));
  return values;
}

/// The largest value over all replicates, averaged or not; NaN if any value is NaN.
double worst(const std::vector<std::vector<double>>& each, std::size_t quantity) {
  double most = 0;
  for (const std::vector<double>& values : each) {
    if (!(values[quantity] <= most)) most = values[quantity];
    if (std::isnan(most)) break;
  }
  return most;
}

}  // namespace

const Quantity& named(const std::vector<Quantity>& list, std::string_view name) {
  const auto found = std::ranges::find(list, name, &Quantity::name);
  if (found == list.end()) throw std::out_of_range("no quantity " + std::string(name));
  return *found;
}

Summary summarise(const Outcome& outcome) {
  const std::vector<Measure> all = measures(outcome.mill_case);
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  std::vector<std::size_t> numbers;
  for (const Replicate* r : chosen) numbers.push_back(number_of(outcome, *r));
  Summary made;
  const cases::CaseBySense by_sense(outcome.mill_case);
  for (std::size_t k = 0; k < outcome.replicates.size(); ++k)
    made.by_replicate.push_back(values_of(all, by_sense.of(k), outcome.replicates[k]));
  made.quantities = means(all, made.by_replicate, numbers, interval_of(outcome.mill_case));
  for (std::size_t i = 0; i < all.size(); ++i) {
    Quantity& q = made.quantities[i];
    if (!outcome.mill_case.uncertainty)
      q.ci95_time = above_rounding_of(q.value, ci95_over_time(chosen, q.name));
    if (!all[i].traits.worst) continue;
    q.value = worst(made.by_replicate, i);
    q.ci95 = undefined;
  }
  const std::array of_whole{settling_time(chosen), static_cast<double>(chosen.size())};
  for (std::size_t i = 0; i < of_whole.size(); ++i) {
    const Measure& m = measures_of_whole()[i];
    made.quantities.push_back({m.name, of_whole[i], undefined, m.unit, m.about});
  }
  made.pairs = by_pair(outcome);
  made.parts = by_part(outcome);
  if (cases::distinct_replicates(outcome.mill_case) == 1)  // they differ by their starts only
    made.two_states = two_states(outcome, all, made.by_replicate);
  made.motion_states = motion_states(outcome);
  made.regime = regime(outcome);
  if (!made.regime.empty())
    made.regime_reason =
        made.motion_states.empty() ? regime_reason(outcome) : motion_reason(made.motion_states);
  return made;
}

}  // namespace mahlwerk::results
