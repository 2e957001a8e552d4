// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/part_loads.hpp"

#include <algorithm>
#include <string>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/wall_faces.hpp"
#include "mahlwerk/results/quantities/means.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using kinematics::PartMotion;
using observe::PairSums;
using scene::WallLoad;

bool has_parts(const Case& c) {
  return !c.machine_parts.empty();
}

/// What part `index` has done to the balls in the counted time.
WallLoad load_of(const Replicate& r, std::size_t index) {
  const std::size_t k = index + 1;  // after the jar
  if (k >= r.loads.size()) return {};
  WallLoad load = r.loads[k];
  if (k < r.loads_at_settled.size()) {
    const WallLoad& before = r.loads_at_settled[k];
    load.impulse -= before.impulse;
    load.angular_impulse -= before.angular_impulse;
    load.work -= before.work;
  }
  return load;
}

/// Sum over the parts of which `counts` holds.
template <class Counts, class Of>
double sum_over(const Case& c, const Counts& counts, const Of& of) {
  double sum = 0;
  for (std::size_t i = 0; i < c.machine_parts.size(); ++i)
    if (counts(c.machine_parts[i])) sum += of(i);
  return sum;
}

bool on_shaft(const cases::MachinePart& part) {
  return part.body.motion.turns();
}
/// Whether there are turning parts, all on one shaft.
bool has_one_shaft(const Case& c) {
  return cases::shaft_part(c) != nullptr;
}

/// [W] What all parts together do to the balls.
double parts_power(const Case& c, const Replicate& r) {
  return share(
      sum_over(
          c, [](const auto&) { return true; }, [&](std::size_t i) { return load_of(r, i).work; }),
      r.time());
}
double shaft_torque(const Case& c, const Replicate& r) {
  return share(sum_over(c, on_shaft, [&](std::size_t i) { return load_of(r, i).angular_impulse; }),
               r.time());
}

/// One quantity of a part in a replicate.
struct PartMeasure {
  const char* name;
  const char* unit;
  const char* about;
  double (*compute)(const WallLoad& load, const PairSums& hits, double time);
};

constexpr PartMeasure part_list[] = {
    {"power", "W", "work of the part on the balls per time",
     [](const WallLoad& l, const PairSums&, double t) { return share(l.work, t); }},
    {"torque", "N m",
     "mean torque of the part on the balls, about its axis of motion or, of a part "
     "at rest, its own",
     [](const WallLoad& l, const PairSums&, double t) { return share(l.angular_impulse, t); }},
    {"force_x", "N", "mean force of the part on the balls, along x of its frame",
     [](const WallLoad& l, const PairSums&, double t) { return share(l.impulse.x, t); }},
    {"force_y", "N", "the same, along y",
     [](const WallLoad& l, const PairSums&, double t) { return share(l.impulse.y, t); }},
    {"force_z", "N", "the same, along z",
     [](const WallLoad& l, const PairSums&, double t) { return share(l.impulse.z, t); }},
    {"collision_rate_above_threshold", "1/s", "hits on the part per second above the threshold",
     [](const WallLoad&, const PairSums& h, double t) {
       return share(static_cast<double>(h.count), t);
     }},
    {"energy_normal_mean_above_threshold", "J", "mean impact energy of these, of the normal motion",
     [](const WallLoad&, const PairSums& h, double) {
       return h.count > 0 ? h.energy_normal / static_cast<double>(h.count) : undefined;
     }}};

/// Hits above the threshold on one part, of all ball sets.
PairSums hits_on(const Case& c, const Replicate& r, std::size_t index) {
  PairSums sum;
  const observe::StatisticsByPair& pairs = r.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto kinds = pairs.kinds_of(pair);
    if (kinds.with_jar() && part_of(c, pairs, kinds.face()) == &c.machine_parts[index])
      sum.add(pairs[pair].above);
  }
  return sum;
}

}  // namespace

Measures part_measures() {
  return where(has_parts, "with `[[parts]]`",
               {{"parts_power",
                 "W",
                 "work of all parts in the jar on the balls per time",
                 parts_power,
                 {.range = any_value, .label = "power of the parts", .equation = "obs.22"}},
                {"parts_torque",
                 "N m",
                 "mean torque of all turning parts on the balls, about their axis",
                 shaft_torque,
                 {.range = any_value,
                  .label = "torque of the turning parts",
                  .equation = "obs.22",
                  .applies = has_one_shaft,
                  .only = "if all turning parts are on one shaft: one line, speed and frame"}}});
}

std::vector<PartSummary> by_part(const Outcome& outcome) {
  const Case& c = outcome.mill_case;
  const std::vector<const Replicate*> chosen = averaged_replicates(outcome);
  std::vector<PartSummary> found;
  if (chosen.empty()) return found;
  for (std::size_t i = 0; i < c.machine_parts.size(); ++i) {
    PartSummary made{c.machine_parts[i].name, {}};
    for (const PartMeasure& m : part_list) {
      std::vector<double> values;
      for (const Replicate* r : chosen)
        values.push_back(m.compute(load_of(*r, i), hits_on(c, *r, i), r->time()));
      combine(made.quantities.emplace_back(Quantity{m.name, 0, 0, m.unit, m.about}), values,
              interval_of(c));
    }
    found.push_back(std::move(made));
  }
  return found;
}

Table parts_table(const std::vector<PartSummary>& parts) {
  Table table{{{"part", "1", "the name of the part"}}, {}};
  for (const PartMeasure& m : part_list) {
    table.columns.push_back({m.name, m.unit, m.about});
    table.columns.push_back({std::string(m.name) + "_ci95", m.unit,
                             "half-width of the 95 % confidence interval of that quantity"});
  }
  for (const PartSummary& part : parts) {
    std::vector<double> row{table.columns[0].number_of(part.name)};
    for (const Quantity& q : part.quantities) row.insert(row.end(), {q.value, q.ci95});
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace mahlwerk::results
