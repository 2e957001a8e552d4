// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/outcome_emulator.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::campaign {

double OutcomeEmulator::transformed(double value) const {
  return logarithmic ? math::log(value) : value;
}
double OutcomeEmulator::value_of(double transformed) const {
  return logarithmic ? math::exp(transformed) : transformed;
}

double OutcomeEmulator::leave_one_out_error() const {
  return hold_out(*this).error;
}

HoldOut hold_out(const OutcomeEmulator& emulator) {
  constexpr double z95 = 1.959963984540054;
  const std::vector<Posterior> others = emulator.model.process.leave_one_out();
  const std::vector<Observation>& own = emulator.model.process.observations();
  const auto count = static_cast<double>(own.size());
  double squares = 0, standardised = 0;
  for (std::size_t i = 0; i < own.size(); ++i) {
    const double off = own[i].value - others[i].mean;
    squares += off * off;
    standardised += off * off / (others[i].deviation * others[i].deviation);
  }
  HoldOut made{.error = std::sqrt(squares / count),
               .widening = std::max(1.0, std::sqrt(standardised / count))};  // (opt.19)
  for (std::size_t i = 0; i < own.size(); ++i)
    if (std::abs(own[i].value - others[i].mean) <= z95 * made.widening * others[i].deviation)
      made.coverage += 1 / count;
  return made;
}

bool varies_by_factors(double least, double most) {
  constexpr double much = 3;
  return least > 0 && most > much * least;
}

}  // namespace mahlwerk::campaign
