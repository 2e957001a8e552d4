// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Quantities that depend on contact.softening (docs/theory/soft.md).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/results/notices/warnings.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {
namespace {

using observe::LogHistogram;

/// [s] Part of the contacts of a pair that softening adds: the part of each contact that is an
/// impact lasts longer by one over `factor` (hea.11).
double added_time(const observe::PairStatistics& pair, const powder::FlashPair& bodies,
                  double factor) {
  const double impacts = static_cast<double>(pair.spectra.energy_normal.total());
  if (!(impacts > 0)) return 0;
  const double mean = pair.spectra.energy_normal.sum() / impacts;
  if (!(mean > 0)) return 0;
  const double longest = powder::impact_phase * powder::hertz_time(mean, bodies) / factor;
  double sum = 0;
  const LogHistogram& durations = pair.spectra.duration;
  const auto [first, end] = durations.occupied_range();
  for (int bin = first; bin < end; ++bin)
    sum += std::min(durations.sum(bin), static_cast<double>(durations.count(bin)) * longest);
  return (1 - factor) * sum;
}

/// [1] The most by which longer impacts can raise contact_time_share: no two of them coincide.
double added_share(const Outcome& outcome, double factor) {
  const cases::Case& c = outcome.mill_case;
  return mean_over(averaged_replicates(outcome), [&](const Replicate& r) {
    double sum = 0;
    for (int i = 0; i < r.tally.by_pair.pairs(); ++i) {
      const auto kinds = r.tally.by_pair.kinds_of(i);
      const auto one = static_cast<std::size_t>(kinds.one);
      sum += kinds.with_jar()
                 ? added_time(r.tally.by_pair[i], cases::flash_pair_with_jar(c, one), factor)
                 : 2 * added_time(r.tally.by_pair[i],
                                  cases::flash_pair(c, one, static_cast<std::size_t>(kinds.other)),
                                  factor);
    }
    return sum / (r.time() * count_of_balls(c));
  });
}

}  // namespace

Notices softened_quantities(const Outcome& outcome) {
  constexpr double seen = 0.01;  // of the balls' time
  const double softening = outcome.mill_case.contact.softening;
  if (!cases::in_time_steps(outcome.engine) || !(softening < 1)) return {};
  if (averaged_replicates(outcome).empty()) return {};
  const double factor = powder::softened_duration(softening);
  const double share = added_share(outcome, factor);
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
