// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
// Warnings where grinding models are used beyond their range of validity.
#include "mahlwerk/parts/grinding/warnings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"

namespace mahlwerk::parts::grinding {
namespace {

using results::dissipated_power;
using results::grinding_replicates;
using results::mean_over;
using results::Outcome;
using results::Replicate;
using results::share;

using Chosen = std::vector<const Replicate*>;

void large_grains(const cases::Case& mill_case, const powder::StressSpectrum& hits, Notices& list) {
  const double size = *mill_case.powder->size;
  double nip = INFINITY;  // smallest effective radius with collisions
  for (const powder::Stress& s : hits.stresses)
    nip = std::min(nip, hits.nips[static_cast<std::size_t>(s.nip)].radius);
  constexpr double large = 0.25;
  if (std::holds_alternative<powder::Barrios>(*mill_case.capture->model) && size > large * nip)
    list.push_back(warning(
        "large-grains",
        fmt::format(
            "Grains of {} are large compared with the balls: the model of a bed one grain high is "
            "valid for grains far smaller than the nip's radius, here {}. The number of captured "
            "grains is a rough estimate.",
            show_rounded(size, "m"), show_rounded(nip, "m"))));
}

void more_than_dissipated(const Chosen& chosen, Notices& list) {
  const double given = mean_over(chosen, [](const Replicate& r) {
    return share(r.grinding->capture.power, dissipated_power(r));
  });
  if (given > 1)
    list.push_back(warning(
        "more-than-dissipated",
        fmt::format("Captured grains get {} times the power that the mill dissipates, which is "
                    "impossible: with powder between its balls a mill loses more in each "
                    "collision. Give a restitution measured with powder, choose [capture] energy "
                    "= \"lost\", or lower energy_share.",
                    two_digits(given))));
}

void all_of_the_powder(const cases::Case& mill_case, const powder::StressSpectrum& hits,
                       Notices& list) {
  const powder::Process process = cases::process(mill_case);
  const powder::Grain grain = process.grain(*mill_case.powder->size);
  constexpr double nearly = 0.999, often = 0.01;
  double whole = 0, all = 0;
  for (const powder::Stress& s : hits.stresses) {
    const powder::Capture c =
        process.capture_per_hit(hits.nips[static_cast<std::size_t>(s.nip)], s.energy, grain.size);
    if (c.grains * grain.mass() >= nearly * mill_case.powder->mass) whole += s.rate * s.energy;
    all += s.rate * s.energy;
  }
  if (whole > often * all)
    list.push_back(warning("catch-cut", fmt::format("Collisions that carry {} % of the power "
                                                    "would capture more powder than there is: "
                                                    "their captured mass was limited to the mass "
                                                    "of the powder.",
                                                    two_digits(100 * whole / all))));
}

void ends_of_the_classes(const cases::Grinding& grinding, const Chosen& chosen, Notices& list) {
  constexpr double much = 0.05, often = 0.01;
  const double finest = mean_over(
      chosen, [](const Replicate& r) { return r.grinding->milling().shares.back().back(); });
  if (finest > much)
    list.push_back(warning(
        "finest-class",
        fmt::format(
            "{} % of the powder are in the finest size class, below {}, where nothing breaks "
            "further: a smaller grinding.smallest resolves more, if the models still hold there.",
            two_digits(100 * finest), show_rounded(grinding.smallest, "m"))));
  const double coarsest = mean_over(
      chosen, [](const Replicate& r) { return r.grinding->milling().shares.back().front(); });
  if (grinding.welding > 0 && coarsest > often)
    list.push_back(
        warning("coarsest-class", fmt::format("{} % of the powder welded into grains of the "
                                              "coarsest size class, sixteen times as large as "
                                              "the feed.",
                                              two_digits(100 * coarsest))));
}

void wide_classes(const cases::Grinding& grinding, const Chosen& chosen, Notices& list) {
  constexpr std::int64_t close = 12;
  const bool binary = std::holds_alternative<powder::BinaryFragments>(*grinding.fragments);
  if (binary && chosen.front()->grinding->balance && grinding.classes_per_octave < close)
    list.push_back(warning(
        "wide-classes",
        fmt::format("With binary fragments one piece is often nearly as large as the grain: with "
                    "{} classes per octave the population balance grinds too slowly, by shares of "
                    "up to {} %. grinding.classes_per_octave = 12, or method = \"statistical\", "
                    "is more accurate.",
                    grinding.classes_per_octave, grinding.classes_per_octave < 6 ? 13 : 3)));
}

/// [J/kg] Largest specific energy that a hit gives to grains of this size.
double strongest_hit(const powder::Process& process, const powder::StressSpectrum& hits,
                     const powder::Grain& grain) {
  double most = 0;
  for (const powder::Stress& s : hits.stresses) {
    if (!(s.rate > 0) || !(s.energy > 0)) continue;
    const powder::Capture c =
        process.capture_per_hit(hits.nips[static_cast<std::size_t>(s.nip)], s.energy, grain.size);
    const double mass = c.grains * grain.mass();
    if (c.probability > 0 && mass > 0)
      most = std::max(most, process.energy_share * s.energy / mass);
  }
  return most;
}

/// [J/kg] Specific energy that breaks one grain of this size in a thousand; infinite if none does.
double least_breaking(const powder::AnyBreakage& breakage, double size) {
  constexpr double rarely = 1e-3, highest = 1e15;
  const auto breaks = [&](double energy) {
    return std::visit([&](const auto& m) { return m.breakage_probability(size, energy); },
                      breakage) >= rarely;
  };
  if (!breaks(highest)) return INFINITY;
  double low = 0, high = highest;
  for (int i = 0; i < 200 && high - low > 1e-6 * high; ++i) {
    const double middle = low > 0 ? std::sqrt(low * high) : high * 1e-3;
    (breaks(middle) ? high : low) = middle;
    if (high < 1e-15) break;
  }
  return high;
}

/// Warns if the sizes at the end are those of the feed.
void nothing_breaks(const cases::Case& mill_case, const Chosen& chosen,
                    const powder::StressSpectrum& hits, Notices& list) {
  constexpr double none = 1e-6;  // of the mass, in another class than at the start
  for (const Replicate* r : chosen) {
    const powder::SizeEvolution& milling = r->grinding->milling();
    const std::vector<double>&first = milling.shares.front(), &last = milling.shares.back();
    for (std::size_t i = 0; i < first.size(); ++i)
      if (std::abs(last[i] - first[i]) > none) return;
  }
  const powder::Process process = cases::process(mill_case);
  const double size = *mill_case.powder->size,
               strongest = strongest_hit(process, hits, process.grain(size));
  list.push_back(warning(
      "nothing-breaks",
      fmt::format(
          "Nothing breaks: no hit exceeds what a grain bears. The strongest hit gives {} to "
          "grains of {}; {} break one of them in a thousand. Heavier balls, a faster mill "
          "or weaker grains change that; the grinding energy is lost as "
          "heat.",
          show_rounded(strongest, "J/kg"), show_rounded(size, "m"),
          show_rounded(least_breaking(*process.breakage, size), "J/kg"))));
}

}  // namespace

Notices warnings(const Outcome& outcome) {
  const Chosen chosen = grinding_replicates(outcome);
  const cases::Case& mill_case = outcome.mill_case;
  Notices list;
  if (chosen.empty() || !mill_case.capture) return list;
  const powder::StressSpectrum hits = stress_spectrum(mill_case, chosen);
  large_grains(mill_case, hits, list);
  more_than_dissipated(chosen, list);
  all_of_the_powder(mill_case, hits, list);
  if (!mill_case.grinding) return list;
  ends_of_the_classes(*mill_case.grinding, chosen, list);
  wide_classes(*mill_case.grinding, chosen, list);
  nothing_breaks(mill_case, chosen, hits, list);
  return list;
}

}  // namespace mahlwerk::parts::grinding
