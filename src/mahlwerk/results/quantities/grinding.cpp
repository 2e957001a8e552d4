// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/grinding.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/results/quantities/kinetics.hpp"
#include "mahlwerk/results/quantities/nips.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using observe::LogHistogram;
using powder::StressSpectrum;

const LogHistogram& energies(const Case& mill_case, const observe::Spectra& spectra) {
  using Energy = cases::Capture::Energy;
  switch (mill_case.capture ? mill_case.capture->energy : mill_case.kinetics->hit_energy) {
    case Energy::normal:
      return spectra.energy_normal;
    case Energy::contact_point:
      return spectra.energy_contact_point;
    case Energy::lost:
      break;
  }
  return spectra.energy_lost;
}

/// Appends the collisions of one kind of pair: one stress per energy bin, at the bin's mean energy,
/// as means over replicates. Bin 0, which holds collisions without energy, is left out.
void add_stresses(const Case& mill_case, const std::vector<const Replicate*>& of, int pair,
                  StressSpectrum& all) {
  for (int bin = 1; bin < LogHistogram::bins; ++bin) {
    double rate = 0, power = 0;
    for (const Replicate* r : of) {
      const LogHistogram& histogram = energies(mill_case, r->tally.by_pair[pair].spectra);
      const double per = 1 / (r->time() * static_cast<double>(of.size()));
      rate += per * static_cast<double>(histogram.count(bin));
      power += per * histogram.sum(bin);
    }
    if (rate > 0) all.stresses.push_back({pair, power / rate, rate});
  }
}

/// Each nip: mean over replicates.
std::vector<powder::Nip> mean_nips(const Case& mill_case, const std::vector<const Replicate*>& of) {
  std::vector<powder::Nip> mean;
  for (const Replicate* r : of) {
    const std::vector<powder::Nip> own = r->grinding && !r->grinding->stresses.nips.empty()
                                             ? r->grinding->stresses.nips
                                             : nips(mill_case, r->tally);
    if (mean.empty()) mean.resize(own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
      mean[i].radius += own[i].radius / static_cast<double>(of.size());
      mean[i].modulus = own[i].modulus;
    }
  }
  return mean;
}

powder::Stream stream_of(const Replicate& r, const std::vector<powder::Nip>& nips) {
  powder::Stream stream{{}, static_cast<double>(r.stream.stride()), r.time()};
  for (const observe::StressStream::Hit& hit : r.stream.hits())
    if (hit.energy > 0 && nips[static_cast<std::size_t>(hit.pair)].radius > 0)
      stream.hits.push_back({hit.energy, hit.pair});
  return stream;
}

powder::SizeEvolution milling_by_sample(const Case& mill_case, const Replicate& r,
                                        const StressSpectrum& stresses, int index) {
  // A random stream of its own, apart from the streams that place balls.
  constexpr std::uint32_t first = 0x706f7764U;
  Random random(mill_case.seed, first + static_cast<std::uint32_t>(index));
  const auto start = static_cast<std::uint64_t>(std::ldexp(random.uniform(), 53));
  return powder::grind_sample(cases::process(mill_case), stresses.nips, stream_of(r, stresses.nips),
                              size_grid(mill_case), mill_case.powder->feed,
                              mill_case.grinding->time,
                              static_cast<int>(mill_case.grinding->sample), start);
}

}  // namespace

observe::StressStream::Energy stream_energy(const Case& mill_case) {
  using Energy = cases::Capture::Energy;
  using Kept = observe::StressStream::Energy;
  switch (mill_case.capture->energy) {
    case Energy::normal:
      return Kept::normal;
    case Energy::contact_point:
      return Kept::contact_point;
    case Energy::lost:
      break;
  }
  return Kept::lost;
}

StressSpectrum stress_spectrum(const Case& mill_case, const std::vector<const Replicate*>& of) {
  StressSpectrum all;
  all.nips = mean_nips(mill_case, of);
  for (int pair = 0; pair < std::ssize(all.nips); ++pair)
    if (all.nips[static_cast<std::size_t>(pair)].radius > 0) add_stresses(mill_case, of, pair, all);
  return all;
}

powder::SizeGrid size_grid(const Case& mill_case) {
  const powder::Feed& feed = mill_case.powder->feed;
  const bool equal = feed.law == powder::Feed::Law::equal;
  const double largest = equal ? feed.size : feed.largest();
  constexpr double room = 16;  // for grains that weld
  return {equal ? feed.size : feed.quantile(0.5),
          mill_case.grinding->welding > 0 ? room * largest : largest, mill_case.grinding->smallest,
          static_cast<int>(mill_case.grinding->classes_per_octave)};
}

powder::SizeEvolution milling_by_balance(const Case& mill_case, const StressSpectrum& stresses,
                                         const powder::CaptureTable* known) {
  return powder::grind_by_balance(cases::process(mill_case), stresses, size_grid(mill_case),
                                  mill_case.powder->feed, mill_case.grinding->time, known);
}

powder::CaptureTable beds(const Case& mill_case, const StressSpectrum& stresses) {
  if (mill_case.grinding->bed == powder::Bed::mixed) return {};
  return powder::capture_table(cases::process(mill_case), stresses, size_grid(mill_case), 0);
}

CaptureRates capture_rates(const Case& mill_case, const StressSpectrum& stresses) {
  const powder::Process process = cases::process(mill_case);
  const powder::Grain grain = process.grain(*mill_case.powder->size);
  CaptureRates rates;
  double energy = 0;
  for (const powder::Stress& s : stresses.stresses) {
    const powder::Capture c = process.capture_per_hit(
        stresses.nips[static_cast<std::size_t>(s.nip)], s.energy, grain.size);
    rates.mass += s.rate * c.mean_mass(grain);
    rates.power += s.rate * c.probability * process.energy_share * s.energy;
    rates.grains += s.rate * s.energy * c.probability * c.grains;
    energy += s.rate * s.energy;
  }
  rates.grains = share(rates.grains, energy);
  return rates;
}

namespace {

bool dose_is_captured(const Case& mill_case) {
  return !mill_case.kinetics || mill_case.kinetics->dose == cases::Kinetics::Dose::captured;
}

}  // namespace

double dose_rate(const Case& mill_case, const std::vector<const Replicate*>& of,
                 const StressSpectrum& stresses) {
  const bool caught = dose_is_captured(mill_case);
  double power = caught ? capture_rates(mill_case, stresses).power : 0;
  if (!caught)
    for (const Replicate* r : of) power += dissipated_power(*r) / static_cast<double>(of.size());
  return power / mill_case.powder->mass;
}

void grind(const Case& mill_case, Replicate& replicate, int index) {
  if (!mill_case.powder || (!mill_case.capture && !mill_case.kinetics) || !(replicate.time() > 0))
    return;
  GrindingOutcome grinding;
  const std::vector<const Replicate*> alone{&replicate};
  if (mill_case.capture) {
    grinding.stresses = stress_spectrum(mill_case, alone);
    grinding.capture = capture_rates(mill_case, grinding.stresses);
  } else if (kinetics_reads_hits(mill_case)) {
    grinding.stresses = stress_spectrum(mill_case, alone);
  }
  grinding.dose_rate = mill_case.capture && dose_is_captured(mill_case)
                           ? grinding.capture.power / mill_case.powder->mass
                           : dose_rate(mill_case, alone, grinding.stresses);
  if (mill_case.kinetics)
    grinding.conditions = milling_conditions(mill_case, alone, grinding.stresses);
  using Method = cases::Grinding::Method;
  if (mill_case.grinding && mill_case.grinding->method != Method::statistical)
    grinding.balance = milling_by_balance(mill_case, grinding.stresses);
  if (mill_case.grinding && mill_case.grinding->method != Method::balance)
    grinding.sample = milling_by_sample(mill_case, replicate, grinding.stresses, index);
  replicate.grinding = std::move(grinding);
}

namespace {

/// `of(grid, shares)` at the end of milling, by the method that counts; NaN without milling.
template <class Of>
double at_end(const Replicate& r, const Of& of) {
  if (!r.grinding || !r.grinding->has_milling()) return undefined;
  const powder::SizeEvolution& milling = r.grinding->milling();
  return of(milling.grid, milling.shares.back());
}

double size_at_end(const Replicate& r, double share) {
  return at_end(r, [&](const auto& grid, const auto& shares) {
    return powder::quantile(grid, shares, share);
  });
}

CaptureRates capture_of(const Replicate& r) {
  return r.grinding ? r.grinding->capture : CaptureRates{undefined, undefined, undefined};
}

}  // namespace

Measures capture_measures() {
  const auto captures = [](const Case& c) { return c.capture.has_value(); };
  return where(
      captures, "with `[capture]`",
      {
          {"captured_mass_rate",
           "kg/s",
           "mass of powder that collisions capture per second",
           [](const Case&, const Replicate& r) { return capture_of(r).mass; },
           {.label = "powder captured",
            .heading = "Powder captured by collisions",
            .column = 4,
            .column_head = "captured"}},
          {"captured_share_rate",
           "1/s",
           "captured mass rate over the mass of the powder: how often a grain is hit",
           [](const Case& c, const Replicate& r) { return capture_of(r).mass / c.powder->mass; },
           {.label = "captures per grain"}},
          {"captured_grains_mean",
           "1",
           "captured grains of the feed's median size in a collision, mean weighted by energy",
           [](const Case&, const Replicate& r) { return capture_of(r).grains; },
           {.label = "grains captured per collision", .column = 5}},
          {"captured_energy_mean",
           "J/g",
           "energy that captured powder gets in a collision, by its mass",
           [](const Case&, const Replicate& r) {
             const CaptureRates rates = capture_of(r);
             return share(rates.power, 1000 * rates.mass);
           },
           {.label = "energy of captured powder"}},
          {"captured_dose_rate",
           "W/g",
           "power that captured grains get, by mass of the powder",
           [](const Case& c, const Replicate& r) {
             return capture_of(r).power / (1000 * c.powder->mass);
           },
           {.label = "power of captured powder"}},
      });
}

Measures grinding_measures() {
  const auto grinds = [](const Case& c) { return c.grinding.has_value(); };
  return where(grinds, "with `[grinding]`",
               {
                   {"d10",
                    "m",
                    "size that 10 % of the powder's mass is finer than, after milling",
                    [](const Case&, const Replicate& r) { return size_at_end(r, 0.1); },
                    {.label = "D10", .symbol = "$d_{10}$", .heading = "Fineness"}},
                   {"d50",
                    "m",
                    "median size by mass, after milling",
                    [](const Case&, const Replicate& r) { return size_at_end(r, 0.5); },
                    {.label = "D50", .symbol = "$d_{50}$", .key = 9, .column = 2}},
                   {"d90",
                    "m",
                    "size that 90 % of the powder's mass is finer than, after milling",
                    [](const Case&, const Replicate& r) { return size_at_end(r, 0.9); },
                    {.label = "D90", .symbol = "$d_{90}$", .column = 1}},
                   {"specific_surface",
                    "m2/kg",
                    "specific surface of spheres of these sizes, after milling",
                    [](const Case& c, const Replicate& r) {
                      return at_end(r, [&](const auto& grid, const auto& shares) {
                        return powder::specific_surface(grid, shares, *c.powder->density);
                      });
                    },
                    {.symbol = "$S_{m}$", .equation = "siz.3"}},
                   {"finest_share",
                    "1",
                    "share of the mass in the finest class, which does not break further",
                    [](const Case&, const Replicate& r) {
                      return at_end(r,
                                    [](const auto&, const auto& shares) { return shares.back(); });
                    },
                    {.range = share_of_whole, .label = "share in the finest class"}},
                   {"specific_grinding_energy",
                    "J/g",
                    "energy that captured grains got over the milling time",
                    [](const Case& c, const Replicate& r) {
                      return capture_of(r).power * c.grinding->time / (1000 * c.powder->mass);
                    },
                    {.label = "grinding energy"}},
               });
}

}  // namespace mahlwerk::results
