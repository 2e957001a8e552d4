// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/pairs.hpp"

#include <algorithm>
#include <limits>

#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/results/csv.hpp"

namespace mahlwerk::results {
namespace {

using observe::ByPair;
using observe::LogHistogram;
using observe::PairSums;
using observe::PairTally;
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A number of one kind of pair in one replicate, whose counted time is `time` [s].
struct PairMeasure {
  std::string name, unit, about;
  double (*of)(const PairTally& tally, double time);
};

double mean_of(const PairSums& sums, double PairSums::*what) {
  return sums.count > 0 ? sums.*what / static_cast<double>(sums.count) : nothing;
}

const std::vector<PairMeasure>& measures() {
  static const std::vector<PairMeasure> list{
      {"collision_rate", "1/s", "collisions of this kind per second",
       [](const PairTally& t, double time) { return static_cast<double>(t.all.count) / time; }},
      {"collision_rate_above_threshold", "1/s",
       "those with a normal speed u_n of at least the threshold",
       [](const PairTally& t, double time) { return static_cast<double>(t.above.count) / time; }},
      {"energy_normal_mean", "J", "mean impact energy of the normal motion, m u_n^2/2",
       [](const PairTally& t, double) { return mean_of(t.all, &PairSums::energy_normal); }},
      {"energy_normal_mean_above_threshold", "J", "of collisions above the threshold",
       [](const PairTally& t, double) { return mean_of(t.above, &PairSums::energy_normal); }},
      {"energy_contact_point_mean", "J", "mean impact energy of the motion of the touching points",
       [](const PairTally& t, double) { return mean_of(t.all, &PairSums::energy_contact_point); }},
      {"energy_contact_point_mean_above_threshold", "J", "of collisions above the threshold",
       [](const PairTally& t, double) {
         return mean_of(t.above, &PairSums::energy_contact_point);
       }},
      {"collision_power_normal", "W", "dissipated along the normal by finished collisions",
       [](const PairTally& t, double time) { return t.all.lost_normal / time; }},
      {"collision_power_tangential", "W", "dissipated across the normal by finished collisions",
       [](const PairTally& t, double time) { return t.all.lost_tangential / time; }},
  };
  return list;
}

std::string name_of(const cases::Case& what, int kind) {
  return kind == ByPair::jar ? "jar" : cases::set_name(what, static_cast<std::size_t>(kind));
}

/// The replicates that means are taken over, if they were counted by pair.
std::vector<const Replicate*> counted(const Outcome& outcome) {
  std::vector<const Replicate*> chosen = averaged(outcome);
  if (!chosen.empty() && chosen.front()->tally.by_pair.pairs() == 0) chosen.clear();
  return chosen;
}

}  // namespace

std::vector<PairSummary> by_pair(const Outcome& outcome) {
  const std::vector<const Replicate*> chosen = counted(outcome);
  std::vector<PairSummary> found;
  if (chosen.empty()) return found;
  const ByPair& first = chosen.front()->tally.by_pair;
  for (int pair = 0; pair < first.pairs(); ++pair) {
    const auto [one, other] = first.kinds_of(pair);
    PairSummary made{name_of(outcome.what, one), name_of(outcome.what, other), {}};
    for (const PairMeasure& m : measures()) {
      std::vector<double> values;
      for (const Replicate* r : chosen) values.push_back(m.of(r->tally.by_pair[pair], r->time()));
      combine(made.quantities.emplace_back(Quantity{m.name, 0, 0, m.unit, m.about}), values);
    }
    found.push_back(std::move(made));
  }
  return found;
}

std::string collisions_by_pair_csv(const std::vector<PairSummary>& pairs) {
  std::vector<std::string> line{"one", "other"};
  for (const PairMeasure& m : measures()) {
    line.push_back(column_name(m.name, m.unit));
    line.push_back(column_name(m.name + "_ci95", m.unit));
  }
  std::string text = csv_line(line);
  for (const PairSummary& pair : pairs) {
    line = {csv_cell(std::string_view(pair.one)), csv_cell(std::string_view(pair.other))};
    for (const Quantity& q : pair.quantities) {
      line.push_back(csv_cell(q.value));
      line.push_back(csv_cell(q.ci95));
    }
    text += csv_line(line);
  }
  return text;
}

std::string spectra_by_pair_csv(const Outcome& outcome) {
  std::string text = csv_line(
      {"one", "other", "energy_low_J", "energy_high_J", "rate_normal_per_s", "power_normal_W"});
  const std::vector<const Replicate*> chosen = counted(outcome);
  if (chosen.empty()) return text;
  const ByPair& first = chosen.front()->tally.by_pair;
  for (int pair = 0; pair < first.pairs(); ++pair) {
    const auto [one, other] = first.kinds_of(pair);
    for (int bin = 0; bin < LogHistogram::bins; ++bin) {
      double rate = 0, power = 0;
      for (const Replicate* r : chosen) {
        const LogHistogram& energies = r->tally.by_pair[pair].energy_normal;
        const double share = 1 / (r->time() * static_cast<double>(chosen.size()));
        rate += static_cast<double>(energies.count(bin)) * share;
        power += energies.sum(bin) * share;
      }
      if (rate == 0) continue;
      const std::string a = name_of(outcome.what, one), b = name_of(outcome.what, other);
      text += csv_line({csv_cell(std::string_view(a)), csv_cell(std::string_view(b)),
                        csv_cell(bin == 0 ? 0 : LogHistogram::lower(bin)),
                        csv_cell(LogHistogram::lower(bin + 1)), csv_cell(rate), csv_cell(power)});
    }
  }
  return text;
}

std::string sizes_csv(const cases::Case& what) {
  if (std::ranges::all_of(what.balls, [](const auto& set) { return set.classes.empty(); }))
    return "";
  std::string text = csv_line({"set", "diameter_m", "count", "mass_share"});
  for (std::size_t i = 0; i < what.balls.size(); ++i) {
    double cubes = 0;
    const auto cube = [](const cases::SizeClass& c) {
      return static_cast<double>(c.count) * c.diameter * c.diameter * c.diameter;
    };
    for (const cases::SizeClass& size : what.balls[i].sizes()) cubes += cube(size);
    for (const cases::SizeClass& size : what.balls[i].sizes())
      text +=
          csv_line({csv_cell(std::string_view(cases::set_name(what, i))), csv_cell(size.diameter),
                    std::to_string(size.count), csv_cell(cube(size) / cubes)});
  }
  return text;
}

}  // namespace mahlwerk::results
