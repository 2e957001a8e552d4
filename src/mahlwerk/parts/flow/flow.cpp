// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Balls that leave the jar and enter it: what passes, what is inside, and how long it stays
// (docs/theory/flow.md).
#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/parts/flow/flow_record.hpp"
#include "mahlwerk/parts/flow/notices.hpp"
#include "mahlwerk/parts/flow/residence.hpp"
#include "mahlwerk/parts/flow/section.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::flow {
namespace {

using cases::Case;
using results::Outcome;
using results::Replicate;
using results::Table;

constexpr double most_samples = 1000;

double interval_of(const Case& c) {
  const double counted = cases::counted_time(c);
  return std::max(c.flow->interval.value_or(counted / 100), counted / most_samples);
}

Amount amount_of(const cases::BallSet& set) {
  Amount all;
  for (const cases::SizeClass& size : set.sizes()) {
    scene::Ball ball;
    ball.radius = 0.5 * size.diameter;
    ball.density = set.layers().mean_density(ball.radius);
    all.add(static_cast<double>(size.count), ball.mass());
  }
  return all;
}

std::unique_ptr<observe::Recorder> recorder(const Case& c) {
  FlowRecord::Setup setup{.inside = {},
                          .balls = static_cast<std::size_t>(cases::balls_count(c.balls)),
                          .interval = interval_of(c),
                          .fresh = 0,
                          .returns = cases::flow_in_jar_frame(c).returns};
  const std::vector<bool> fresh = cases::fresh_sets(c);
  for (std::size_t i = 0; i < fresh.size(); ++i) {
    const Amount all = amount_of(c.balls[i]);
    setup.inside.push_back(fresh[i] ? Amount() : all);
    setup.fresh += fresh[i] ? all.count : 0;
  }
  return std::make_unique<FlowRecord>(setup);
}

/// By number and by mass (flo.4); of a hole in a floor they follow Beverloo (flo.8).
double discharge_rate(const Case&, const Replicate& r) {
  return results::share(record_of(r).all().left.count, r.time());
}
double discharge_mass_rate(const Case&, const Replicate& r) {
  return results::share(record_of(r).all().left.mass, r.time());
}
double feed_rate(const Case&, const Replicate& r) {
  return results::share(record_of(r).all().entered.count, r.time());
}
double feed_mass_rate(const Case&, const Replicate& r) {
  return results::share(record_of(r).all().entered.mass, r.time());
}
double holdup(const Case&, const Replicate& r) {
  return r.time() > 0 ? record_of(r).mean_inside(r.energy_balance.time).count : results::undefined;
}
double holdup_mass(const Case&, const Replicate& r) {
  return r.time() > 0 ? record_of(r).mean_inside(r.energy_balance.time).mass : results::undefined;
}

/// [s] Little's law (flo.5).
double residence_time(const Case& c, const Replicate& r) {
  return results::share(holdup(c, r), discharge_rate(c, r));
}

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.flow.has_value(); };
  return results::where(
      present, "with `[flow]`",
      {{"discharge_rate",
        "1/s",
        "balls that left per second",
        discharge_rate,
        {.equation = "flo.4", .heading = "Flow"}},
       {"discharge_mass_rate",
        "kg/s",
        "mass of the balls that left per second",
        discharge_mass_rate,
        {.equation = "flo.4"}},
       {"feed_rate",
        "1/s",
        "balls that entered per second",
        feed_rate,
        {.equation = "flo.4", .applies = is_fed, .only = "with a feed in `[flow]`"}},
       {"feed_mass_rate",
        "kg/s",
        "mass of the balls that entered per second",
        feed_mass_rate,
        {.equation = "flo.4", .applies = is_fed, .only = "with a feed in `[flow]`"}},
       {"holdup", "1", "mean number of balls in the jar", holdup, {.equation = "flo.2"}},
       {"holdup_mass", "kg", "mean mass of the balls in the jar", holdup_mass, {}},
       {"residence_time",
        "s",
        "mean time from entry to exit, by what is inside over what leaves",
        residence_time,
        {.equation = "flo.5", .applies = is_fed, .only = "with a feed in `[flow]`"}},
       {"tracer_residence_time",
        "s",
        "the same by the balls that entered, each followed until it left",
        [](const Case&, const Replicate& r) { return of_tracers(r).mean; },
        {.equation = "flo.7", .applies = is_fed, .only = "with a feed in `[flow]`"}},
       {"residence_time_spread",
        "s",
        "standard deviation of the residence times of these balls",
        [](const Case&, const Replicate& r) { return of_tracers(r).spread; },
        {.equation = "flo.7", .applies = is_fed, .only = "with a feed in `[flow]`"}}});
}

/// A row for each ball set at each time: means over the replicates.
Table series(const Outcome& outcome) {
  Table table{{{"time", "s", "time since counting began"},
               {"set", "1", "number of the ball set"},
               {"left", "1", "balls that have left since then"},
               {"entered", "1", "balls that have entered since then"},
               {"inside", "1", "balls in the jar"},
               {"mass_left", "kg", "mass that has left since then"},
               {"mass_entered", "kg", "mass that has entered since then"},
               {"mass_inside", "kg", "mass in the jar"}},
              {}};
  const auto chosen = results::averaged_replicates(outcome);
  const std::size_t least =
      results::fewest_over(chosen, [](const Replicate& r) { return record_of(r).times().size(); });
  for (std::size_t i = 0; i < least; ++i)
    for (std::size_t set = 0; set < record_of(*chosen.front()).sets(); ++set) {
      const auto of = [&](Amount Holdup::*what, double Amount::*member) {
        return results::mean_over(
            chosen, [&](const Replicate& r) { return record_of(r).sample(i, set).*what.*member; });
      };
      table.rows.push_back({record_of(*chosen.front()).times()[i], static_cast<double>(set + 1),
                            of(&Holdup::left, &Amount::count), of(&Holdup::entered, &Amount::count),
                            of(&Holdup::inside, &Amount::count), of(&Holdup::left, &Amount::mass),
                            of(&Holdup::entered, &Amount::mass),
                            of(&Holdup::inside, &Amount::mass)});
    }
  return table;
}

/// Residence times of the balls of all replicates together.
Table residence(const Outcome& outcome) {
  constexpr std::size_t most_rows = 1000;
  Table table{{{"time", "s", "time since the entry of a ball"},
               {"share_left", "1", "share of the balls that have left by then"}},
              {}};
  std::vector<Tracer> all;
  for (const Replicate* r : results::averaged_replicates(outcome)) {
    const std::vector<Tracer> more = record_of(*r).tracers(r->energy_balance.time);
    all.insert(all.end(), more.begin(), more.end());
  }
  const auto& steps = residence_times(std::move(all)).steps;
  const std::size_t each = steps.size() / most_rows + 1;
  for (std::size_t k = 0; k < steps.size(); ++k)
    if (k % each == 0 || k + 1 == steps.size())
      table.rows.push_back({steps[k].time, 1 - steps[k].inside});
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  std::vector<results::NamedTable> all{
      {"flow", "balls that left, entered and are inside over time, by ball set", series(outcome)}};
  if (is_fed(outcome.mill_case))
    all.push_back({"residence", "distribution of the residence times", residence(outcome)});
  return all;
}

std::string panel(const Outcome& outcome) {
  const Table table = series(outcome);
  const std::vector<double> set = report::column(table, "set"),
                            time = report::column(table, "time"),
                            left = report::column(table, "mass_left"),
                            inside = report::column(table, "mass_inside");
  std::vector<double> at, all_left, all_inside;
  for (std::size_t k = 0; k < time.size(); ++k) {
    if (set[k] == 1) at.push_back(time[k]), all_left.push_back(0), all_inside.push_back(0);
    all_left.back() += left[k], all_inside.back() += inside[k];
  }
  return report::figure({.title = "Flow",
                         .x = report::Axis{.label = "time (s)", .least = 0},
                         .y = report::Axis{.label = "mass (kg)", .least = 0},
                         .series = {{"left", at, all_left, {}, report::Mark::line},
                                    {"inside", at, all_inside, {}, report::Mark::line}},
                         .shape = 0.42},
                        "Mass that has left since counting began, and mass in the jar. flow.csv "
                        "has the numbers of each ball set.");
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "flow",
      .sections = {cases::section_in_case<&Case::flow, describe>(
          {"flow", "", "balls that leave the jar and enter it, counted"})},
      .check = check,
      .recorder = recorder,
      .quantities = quantities,
      .tables = tables,
      .notices = notices,
      .heading = "Flow",
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::flow
