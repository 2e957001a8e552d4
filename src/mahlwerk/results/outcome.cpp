// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/outcome.hpp"

#include <algorithm>
#include <cmath>

namespace mahlwerk::results {

double value_of(const Outcome& outcome, const Replicate& replicate, std::string_view quantity) {
  const std::vector<Quantity>& names = outcome.summary.quantities;
  const auto at = std::ranges::find(names, quantity, &Quantity::name) - names.begin();
  const std::vector<double>& values =
      outcome.summary.by_replicate[number_of(outcome, replicate) - 1];
  return at < std::ssize(values) ? values[static_cast<std::size_t>(at)] : NAN;
}

std::vector<const Replicate*> averaged_replicates(const Outcome& outcome) {
  std::vector<const Replicate*> whole, any;
  for (const Replicate& r : outcome.replicates) {
    if (!(r.time() > 0)) continue;
    any.push_back(&r);
    if (r.complete) whole.push_back(&r);
  }
  return whole.size() >= 2 ? whole : any;
}

std::vector<const Replicate*> grinding_replicates(const Outcome& outcome) {
  std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  std::erase_if(chosen, [](const Replicate* r) { return !r->grinding; });
  return chosen;
}

bool complete(const Outcome& outcome) {
  return !outcome.replicates.empty() &&
         std::all_of(outcome.replicates.begin(), outcome.replicates.end(),
                     [](const Replicate& r) { return r.complete && r.time() > 0; });
}

}  // namespace mahlwerk::results
