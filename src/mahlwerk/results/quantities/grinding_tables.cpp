// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Tables of the powder: capture, grinding, size distribution.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"

namespace mahlwerk::results {
namespace {

using powder::SizeEvolution;

using MillingOf = std::optional<SizeEvolution> GrindingOutcome::*;
const SizeEvolution& milling(const Replicate& r, MillingOf method) {
  return *((*r.grinding).*method);
}

std::vector<MillingOf> methods(const Replicate& r) {
  std::vector<MillingOf> list;
  for (const MillingOf method : {&GrindingOutcome::balance, &GrindingOutcome::sample})
    if (((*r.grinding).*method).has_value()) list.push_back(method);
  return list;
}

/// Prefix of the sample's column names where there is a balance, too.
std::string prefix(const Replicate& r, MillingOf method) {
  return methods(r).size() == 2 && method == &GrindingOutcome::sample ? "sample_" : "";
}

}  // namespace

Table capture(const Outcome& outcome) {
  Table table{pair_columns(), {}};
  for (const Column& c : std::vector<Column>{
           {"energy", "J", "mean energy of the collisions in a bin, as [capture] energy says"},
           {"rate", "1/s", "collisions per second"},
           {"grains", "1", "grains of the feed's median size that such a collision captures"},
           {"mass", "kg", "mean captured mass"},
           {"radius", "m", "radius of the area on which they are captured"},
           {"energy_per_grain", "J", "energy that each captured grain gets"},
           {"specific_energy", "J/kg", "energy that each captured grain gets, by its mass"}})
    table.columns.push_back(c);
  const std::vector<const Replicate*> chosen = grinding_replicates(outcome);
  if (!outcome.mill_case.capture || chosen.empty()) return table;
  const powder::Process process = cases::process(outcome.mill_case);
  const powder::Grain grain = process.grain(*outcome.mill_case.powder->size);
  const powder::StressSpectrum all = stress_spectrum(outcome.mill_case, chosen);
  for (const powder::Stress& s : all.stresses) {
    const powder::Capture c =
        process.capture_per_hit(all.nips[static_cast<std::size_t>(s.nip)], s.energy, grain.size);
    std::vector<double> row =
        pair_cells(table, pair_names(outcome.mill_case, chosen.front()->tally.by_pair, s.nip));
    const double each = process.energy_share * s.energy / c.grains;
    row.insert(row.end(), {s.energy, s.rate, c.probability * c.grains, c.mean_mass(grain), c.radius,
                           each, each / grain.mass()});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table captured_grains(const Outcome& outcome) {
  Table table{
      {{"grains_low", "1", "grains captured by a collision, lower edge of the bin"},
       {"grains_high", "1", "upper edge of the bin; the first bin holds single grains only"},
       {"rate", "1/s", "collisions per second"},
       {"power", "W", "sum of the energies of these collisions per second"}},
      {}};
  const std::vector<const Replicate*> chosen = grinding_replicates(outcome);
  if (!outcome.mill_case.capture || chosen.empty()) return table;
  const powder::Process process = cases::process(outcome.mill_case);
  const powder::StressSpectrum all = stress_spectrum(outcome.mill_case, chosen);
  std::map<int, std::array<double, 2>> bins;  // quarters of an octave; 0: one grain
  for (const powder::Stress& s : all.stresses) {
    const powder::Capture c = process.capture_per_hit(all.nips[static_cast<std::size_t>(s.nip)],
                                                      s.energy, *outcome.mill_case.powder->size);
    const int bin = c.grains > 1 ? 1 + static_cast<int>(4 * math::log2(c.grains)) : 0;
    auto& [rate, power] = bins[bin];
    rate += s.rate * c.probability;
    power += s.rate * c.probability * s.energy;
  }
  for (const auto& [bin, sums] : bins)
    table.rows.push_back({bin == 0 ? 1 : math::exp2(0.25 * (bin - 1)),
                          bin == 0 ? 1 : math::exp2(0.25 * bin), sums[0], sums[1]});
  return table;
}

Table grinding(const Outcome& outcome) {
  Table table{{{"time", "s", "milling time"},
               {"specific_energy", "J/g", "energy that captured grains got until then"}},
              {}};
  const std::vector<const Replicate*> chosen = grinding_replicates(outcome);
  if (!outcome.mill_case.grinding || chosen.empty()) return table;
  constexpr std::array<std::pair<double, const char*>, 3> shares{
      {{0.1, "d10"}, {0.5, "d50"}, {0.9, "d90"}}};
  const Replicate& first = *chosen.front();
  for (const MillingOf method : methods(first)) {
    for (const auto& [share, name] : shares)
      table.columns.push_back(
          {prefix(first, method) + name, "m",
           fmt::format("size that {:.0f} % of the mass is finer than{}", 100 * share,
                       method == &GrindingOutcome::sample ? ", of the sample" : "")});
    table.columns.push_back({prefix(first, method) + "specific_surface", "m2/kg",
                             "specific surface of spheres of these sizes"});
  }
  const double power =
      mean_over(chosen, [](const Replicate& r) { return r.grinding->capture.power; });
  const std::vector<double>& times = milling(first, methods(first).front()).time;
  for (std::size_t i = 0; i < times.size(); ++i) {
    std::vector<double> row{times[i], power * times[i] / (1000 * outcome.mill_case.powder->mass)};
    for (const MillingOf method : methods(first)) {
      for (const auto& [share, name] : shares)
        row.push_back(mean_over(chosen, [&, part = share](const Replicate& r) {
          const SizeEvolution& m = milling(r, method);
          return powder::quantile(m.grid, m.shares[i], part);
        }));
      row.push_back(mean_over(chosen, [&](const Replicate& r) {
        const SizeEvolution& m = milling(r, method);
        return powder::specific_surface(m.grid, m.shares[i], *outcome.mill_case.powder->density);
      }));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table size_distribution(const Outcome& outcome) {
  Table table{{{"time", "s", "milling time"},
               {"size_low", "m", "lower edge of the class"},
               {"size_high", "m", "upper edge of the class"}},
              {}};
  const std::vector<const Replicate*> chosen = grinding_replicates(outcome);
  if (!outcome.mill_case.grinding || chosen.empty()) return table;
  const Replicate& first = *chosen.front();
  for (const MillingOf method : methods(first)) {
    const std::string before = prefix(first, method);
    table.columns.push_back({before + "share", "1", "share of the mass in the class"});
    table.columns.push_back({before + "density", "1", "share per unit of the logarithm of size"});
    table.columns.push_back(
        {before + "passing", "1", "share of the mass finer than the upper edge"});
  }
  constexpr std::array times{0.0, 1.0 / 16, 1.0 / 8, 1.0 / 4, 1.0 / 2, 1.0};
  const powder::SizeGrid& grid = milling(first, methods(first).front()).grid;
  for (const double part : times) {
    const double time = part * outcome.mill_case.grinding->time;
    std::vector<std::vector<double>> shares;  // of each method
    for (const MillingOf method : methods(first)) {
      std::vector<double>& sum = shares.emplace_back(static_cast<std::size_t>(grid.classes()));
      for (const Replicate* r : chosen) {
        const std::vector<double> one = milling(*r, method).at(time);
        for (std::size_t c = 0; c < sum.size(); ++c)
          sum[c] += one[c] / static_cast<double>(chosen.size());
      }
    }
    std::vector<double> passing(shares.size());
    for (int i = grid.classes() - 1; i >= 0; --i) {  // from fine to coarse
      std::vector<double> row{time, grid.lower(i), grid.upper(i)};
      for (std::size_t m = 0; m < shares.size(); ++m) {
        const double share = shares[m][static_cast<std::size_t>(i)];
        passing[m] += share;
        row.insert(row.end(),
                   {share, share / math::log(grid.upper(i) / grid.lower(i)), passing[m]});
      }
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

}  // namespace mahlwerk::results
