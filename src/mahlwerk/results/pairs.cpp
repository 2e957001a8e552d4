// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/pairs.hpp"

#include <algorithm>
#include <limits>

#include "mahlwerk/cases/pairs.hpp"

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

std::vector<Column> pair_columns() {
  return {{"one", "1", "a ball set"}, {"other", "1", "what it collides with: a ball set, or jar"}};
}

/// The first two cells of a row.
std::vector<double> pair_cells(Table& table, std::string_view one, std::string_view other) {
  return {table.columns[0].number_of(one), table.columns[1].number_of(other)};
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

Table collisions_by_pair(const std::vector<PairSummary>& pairs) {
  Table table{pair_columns(), {}};
  for (const PairMeasure& m : measures()) {
    table.columns.push_back({m.name, m.unit, m.about});
    table.columns.push_back({m.name + "_ci95", m.unit, "its half-width at 95 %"});
  }
  for (const PairSummary& pair : pairs) {
    std::vector<double> row = pair_cells(table, pair.one, pair.other);
    for (const Quantity& q : pair.quantities) row.insert(row.end(), {q.value, q.ci95});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table spectra_by_pair(const Outcome& outcome) {
  Table table{pair_columns(), {}};
  table.columns.insert(table.columns.end(),
                       {{"energy_low", "J", "lower edge of the bin, which belongs to it"},
                        {"energy_high", "J", "upper edge of the bin"},
                        {"rate_normal", "1/s", "collisions per second by m u_n^2/2"},
                        {"power_normal", "W", "the sum of those energies per second"}});
  const std::vector<const Replicate*> chosen = counted(outcome);
  if (chosen.empty()) return table;
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
      std::vector<double> row =
          pair_cells(table, name_of(outcome.what, one), name_of(outcome.what, other));
      const double low = bin == 0 ? 0 : LogHistogram::lower(bin);
      row.insert(row.end(), {low, LogHistogram::lower(bin + 1), rate, power});
      table.rows.push_back(std::move(row));
    }
  }
  return table;
}

Table sizes(const cases::Case& what) {
  Table table{{{"set", "1", "the ball set"},
               {"diameter", "m", "diameter of this size of ball"},
               {"count", "1", "balls of this size"},
               {"mass_share", "1", "of the set's mass"}},
              {}};
  if (std::ranges::all_of(what.balls, [](const auto& set) { return set.classes.empty(); }))
    return table;
  for (std::size_t i = 0; i < what.balls.size(); ++i) {
    double cubes = 0;
    const auto cube = [](const cases::SizeClass& c) {
      return static_cast<double>(c.count) * c.diameter * c.diameter * c.diameter;
    };
    for (const cases::SizeClass& size : what.balls[i].sizes()) cubes += cube(size);
    const double set = table.columns[0].number_of(cases::set_name(what, i));
    for (const cases::SizeClass& size : what.balls[i].sizes())
      table.rows.push_back(
          {set, size.diameter, static_cast<double>(size.count), cube(size) / cubes});
  }
  return table;
}

}  // namespace mahlwerk::results
