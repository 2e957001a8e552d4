// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/pairs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/results/quantities/means.hpp"

namespace mahlwerk::results {
namespace {

using observe::PairStatistics;
using observe::PairSums;
using observe::StatisticsByPair;

/// A kind of pair: its names, and the indices of the pairs that it sums.
struct PairKind {
  std::string one, other;
  std::vector<int> pairs;
};

double mean_of(const PairSums& sums, double PairSums::*what) {
  return sums.count > 0 ? sums.*what / static_cast<double>(sums.count) : undefined;
}

constexpr std::string_view jar = "jar";

/// Kinds of pairs. All faces of the jar count as one, each part as one.
std::vector<PairKind> kinds_of_pairs(const cases::Case& mill_case, const StatisticsByPair& pairs) {
  std::vector<PairKind> list;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto kinds = pairs.kinds_of(pair);
    const std::string one = cases::set_name(mill_case, static_cast<std::size_t>(kinds.one));
    const cases::MachinePart* part =
        kinds.with_jar() ? part_of(mill_case, pairs, kinds.face()) : nullptr;
    if (kinds.with_jar() && part == nullptr && kinds.face() > 0) {
      list.back().pairs.push_back(pair);
      continue;
    }
    list.push_back({one,
                    part != nullptr ? "parts." + part->name
                    : kinds.with_jar()
                        ? std::string(jar)
                        : cases::set_name(mill_case, static_cast<std::size_t>(kinds.other)),
                    {pair}});
  }
  return list;
}

PairSums sums_of(const Replicate& r, const PairKind& kind, PairSums (*of)(const PairStatistics&)) {
  PairSums sum;
  for (const int pair : kind.pairs) sum.add(of(r.tally.by_pair[pair]));
  return sum;
}

}  // namespace

const std::vector<PairMeasure>& pair_measures() {
  static const std::vector<PairMeasure> list{
      {"collision_rate", "1/s", "collisions of this kind per second",
       [](const PairTotals& t, double time) { return static_cast<double>(t.all.count) / time; }},
      {"collision_rate_above_threshold", "1/s",
       "collisions of this kind per second with a normal speed u_n of at least the threshold",
       [](const PairTotals& t, double time) { return static_cast<double>(t.above.count) / time; }},
      {"energy_normal_mean", "J", "mean impact energy of the normal motion, m u_n^2/2",
       [](const PairTotals& t, double) { return mean_of(t.all, &PairSums::energy_normal); }},
      {"energy_normal_mean_above_threshold", "J",
       "mean impact energy of the normal motion; collisions above the threshold",
       [](const PairTotals& t, double) { return mean_of(t.above, &PairSums::energy_normal); }},
      {"energy_contact_point_mean", "J", "mean impact energy of the motion of the contact points",
       [](const PairTotals& t, double) { return mean_of(t.all, &PairSums::energy_contact_point); }},
      {"energy_contact_point_mean_above_threshold", "J",
       "mean impact energy of the motion of the contact points; collisions above the threshold",
       [](const PairTotals& t, double) {
         return mean_of(t.above, &PairSums::energy_contact_point);
       }},
      {"collision_power_normal", "W", "power dissipated along the normal by finished collisions",
       [](const PairTotals& t, double time) { return t.all.lost_normal / time; }},
      {"collision_power_tangential", "W",
       "power dissipated across the normal by finished collisions",
       [](const PairTotals& t, double time) { return t.all.lost_tangential / time; }},
  };
  return list;
}

int distinguished_jar_faces(const cases::Case& mill_case, const StatisticsByPair& pairs) {
  return pairs.faces() - static_cast<int>(mill_case.machine_parts.size());
}

const cases::MachinePart* part_of(const cases::Case& mill_case, const StatisticsByPair& pairs,
                                  int face) {
  const int first = distinguished_jar_faces(mill_case, pairs);
  return face < first ? nullptr : &mill_case.machine_parts[static_cast<std::size_t>(face - first)];
}

std::vector<Column> pair_columns() {
  return {{"one", "1", "a ball set"},
          {"other", "1", "its collision partner: a ball set, the jar or a face of it"}};
}

std::vector<double> pair_cells(Table& table, const std::array<std::string, 2>& names) {
  return {table.columns[0].number_of(names[0]), table.columns[1].number_of(names[1])};
}

std::array<std::string, 2> pair_names(const cases::Case& mill_case, const StatisticsByPair& pairs,
                                      int pair) {
  const auto kinds = pairs.kinds_of(pair);
  const std::string one = cases::set_name(mill_case, static_cast<std::size_t>(kinds.one));
  if (!kinds.with_jar())
    return {one, cases::set_name(mill_case, static_cast<std::size_t>(kinds.other))};
  if (const cases::MachinePart* part = part_of(mill_case, pairs, kinds.face()))
    return {one, "parts." + part->name};
  const std::vector<std::string> faces = geometry::face_names(*mill_case.jar.shape);
  if (faces.size() < 2 || distinguished_jar_faces(mill_case, pairs) == 1)
    return {one, std::string(jar)};
  return {one, fmt::format("{}.{}", jar, faces[static_cast<std::size_t>(kinds.face())])};
}

std::vector<PairSummary> by_pair(const Outcome& outcome) {
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  std::vector<PairSummary> found;
  if (chosen.empty()) return found;
  const std::vector<PairKind> kinds =
      kinds_of_pairs(outcome.mill_case, chosen.front()->tally.by_pair);
  if (kinds.size() == 1 || cases::kinds_of_balls(outcome.mill_case).size() == 1) return found;
  for (const PairKind& kind : kinds) {
    PairSummary made{kind.one, kind.other, {}};
    std::vector<PairTotals> totals;
    for (const Replicate* r : chosen)
      totals.push_back({sums_of(*r, kind, [](const PairStatistics& t) { return t.all(); }),
                        sums_of(*r, kind, [](const PairStatistics& t) { return t.above; })});
    for (const PairMeasure& m : pair_measures()) {
      std::vector<double> values;
      for (std::size_t i = 0; i < chosen.size(); ++i)
        values.push_back(m.compute(totals[i], chosen[i]->time()));
      combine(made.quantities.emplace_back(Quantity{m.name, 0, 0, m.unit, m.about}), values,
              interval_of(outcome.mill_case));
    }
    found.push_back(std::move(made));
  }
  return found;
}

Table collisions_by_pair(const std::vector<PairSummary>& pairs) {
  Table table{pair_columns(), {}};
  for (const PairMeasure& m : pair_measures()) {
    table.columns.push_back({m.name, m.unit, m.about});
    table.columns.push_back(
        {m.name + "_ci95", m.unit, "half-width of the 95 % confidence interval of that quantity"});
  }
  for (const PairSummary& pair : pairs) {
    std::vector<double> row = pair_cells(table, {pair.one, pair.other});
    for (const Quantity& q : pair.quantities) row.insert(row.end(), {q.value, q.ci95});
    table.rows.push_back(std::move(row));
  }
  return table;
}

Table sizes(const cases::Case& mill_case) {
  Table table{{{"set", "1", "the ball set"},
               {"diameter", "m", "diameter of this size of ball"},
               {"count", "1", "balls of this size"},
               {"mass_share", "1", "share of the set's mass"}},
              {}};
  if (std::ranges::all_of(mill_case.balls, [](const auto& set) { return set.classes.empty(); }))
    return table;
  for (std::size_t i = 0; i < mill_case.balls.size(); ++i) {
    double cubes = 0;
    const auto cube = [](const cases::SizeClass& c) {
      return static_cast<double>(c.count) * c.diameter * c.diameter * c.diameter;
    };
    for (const cases::SizeClass& size : mill_case.balls[i].sizes()) cubes += cube(size);
    const double set = table.columns[0].number_of(cases::set_name(mill_case, i));
    for (const cases::SizeClass& size : mill_case.balls[i].sizes())
      table.rows.push_back(
          {set, size.diameter, static_cast<double>(size.count), cube(size) / cubes});
  }
  return table;
}

}  // namespace mahlwerk::results
