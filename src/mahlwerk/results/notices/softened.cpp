// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities that depend on contact.softening (docs/theory/soft.md).
#include <fmt/format.h>

#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/powder/flash.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/softening.hpp"

namespace mahlwerk::results {

Notices softened_quantities(const Outcome& outcome) {
  constexpr double seen = 0.01;  // of the balls' time
  const double softening = outcome.mill_case.contact.softening;
  if (!cases::in_time_steps(outcome.engine) || !(softening < 1)) return {};
  if (averaged_replicates(outcome).empty()) return {};
  const double factor = powder::softened_duration(softening);
  const double share = mean_over(averaged_replicates(outcome), [&](const Replicate& r) {
    return share_by_softening(outcome.mill_case, r);
  });
  std::string text = fmt::format(
      "contact.softening = {}: impacts last {} times longer and overlap {} times deeper than with "
      "the given moduli, with {} times the force (Hertz). deepest_overlap and durations.csv "
      "are those of the softened contacts; contact_time_share is larger",
      show(softening, ""), two_digits(1 / factor), two_digits(1 / factor), two_digits(factor));
  text += share > seen ? fmt::format(
                             " by up to {}, and what follows from it (flight_share, "
                             "collision_rate_in_flight) changes with it.",
                             two_digits(share))
                       : fmt::format(" by at most {}.", two_digits(std::fmax(share, 0)));
  if (!contact::adhesion(*outcome.mill_case.contact.model.law).empty())
    text += " Adhesion acts on larger contacts: balls stick at higher speeds than real ones.";
  return {share > seen ? warning("softened-quantities", text) : note("softened-quantities", text)};
}

}  // namespace mahlwerk::results
