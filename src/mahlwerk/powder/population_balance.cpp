// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/population_balance.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

PopulationBalance::PopulationBalance(Process process, StressSpectrum stresses, SizeGrid grid,
                                     const std::vector<double>& feed, const CaptureTable* known)
    : process_(std::move(process)),
      stresses_(std::move(stresses)),
      grid_(grid),
      levels_(strength_levels(*process_.breakage)) {
  for (const double share : feed)
    for (const double fresh : levels_.fresh) states_.push_back(share * fresh);
  if (process_.bed == Bed::mixed) return;
  rates_ =
      known != nullptr ? rate_matrix(process_, stresses_, grid_, levels_, *known) : rates_at(0);
}

std::vector<double> PopulationBalance::shares() const {
  std::vector<double> found(static_cast<std::size_t>(grid_.classes()));
  const auto each = static_cast<std::size_t>(levels_.count());
  for (std::size_t i = 0; i < states_.size(); ++i) found[i / each] += states_[i];
  return found;
}

RateMatrix PopulationBalance::rates_at(double mean_size) const {
  return rate_matrix(process_, stresses_, grid_, levels_,
                     capture_table(process_, stresses_, grid_, mean_size));
}

void PopulationBalance::advance(double time) {
  if (process_.bed == Bed::mixed) return advance_mixed(time);
  if (transition_ && time == 2 * transition_->first) {
    transition_ = {time, product(transition_->second, transition_->second)};
    normalize_columns(transition_->second);
  } else if (!transition_ || time != transition_->first) {
    transition_ = {time, transition_matrix(*rates_, time)};
  }
  states_ = product(transition_->second, states_);
}

// Midpoint rule: a trial step gives the mean size at its end; the step uses the rates at the
// geometric mean of both sizes. Steps are halved until the mean size changes by at most 5 %
// (pbm.5).
void PopulationBalance::advance_mixed(double time) {
  constexpr double max_change = 0.05;
  double left = time, next = time;
  const auto mean = [&] { return mean_size(grid_, shares()); };
  while (left > 0) {
    next = std::min(next, left);
    const std::vector<double> before = states_;
    const double from = mean();
    const RateMatrix now = rates_at(from);
    double to = from;
    for (;; next *= 0.5) {
      states_ = product(transition_matrix(now, next), before);
      to = mean();
      if (std::abs(math::log(to / from)) <= max_change) break;
    }
    if (to != from)
      states_ = product(transition_matrix(rates_at(std::sqrt(from * to)), next), before);
    left -= next;
    next *= 2;
  }
}

}  // namespace mahlwerk::powder
