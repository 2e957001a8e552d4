// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/softening.hpp"

#include <algorithm>

#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/powder/flash.hpp"
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

}  // namespace

double share_by_softening(const cases::Case& c, const Replicate& r) {
  if (r.read_before) return r.read_before->share_by_softening;
  const double factor = powder::softened_duration(c.contact.softening);
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
}

}  // namespace mahlwerk::results
