// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Grains that break while they move: how many, at what energy, and how fine the powder gets
// (docs/theory/bed-breakage.md).
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/parts/bed_breakage/section.hpp"
#include "mahlwerk/parts/bed_breakage/size_record.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::bed_breakage {
namespace {

using cases::Case;
using results::Outcome;
using results::Replicate;
using results::Table;

const SizeRecord& record_of(const Replicate& r) {
  return *r.recorders.find<SizeRecord>();
}

std::unique_ptr<observe::Recorder> recorder(const Case& c) {
  const auto rule = powder::grain_breakage(cases::bed_breakage(c));
  std::vector<double> mass(static_cast<std::size_t>(rule->classes()));
  const cases::BallSet& grains = c.balls.back();
  for (std::int64_t n = 0; n < grains.count; ++n) {
    const double size = rule->at_start(n, grains.diameter).size;
    mass[static_cast<std::size_t>(rule->class_of(size))] += grains.mass();
  }
  return std::make_unique<SizeRecord>(
      std::move(mass), c.bed_breakage->interval.value_or(cases::counted_time(c) / 100));
}

std::vector<double> shares(const SizeSample& sample) {
  std::vector<double> found = sample.mass;
  const double all = std::accumulate(found.begin(), found.end(), 0.0);
  for (double& one : found) one /= all;
  return found;
}

/// [m] Size that a mass share of the powder is finer than.
double quantile_of(const Case& c, const SizeSample& sample, double share) {
  return powder::quantile(cases::bed_breakage(c).grid(), shares(sample), share);
}
template <int percent>
double at_end(const Case& c, const Replicate& r) {
  return quantile_of(c, record_of(r).now(), 0.01 * percent);
}

/// [1] Mass share of the particles that are not simulated.
double fines_share(const Case& c, const Replicate& r) {
  const std::size_t spheres = cases::bed_breakage(c).diameters().size();
  const std::vector<double> all = shares(record_of(r).now());
  return std::accumulate(all.begin() + static_cast<std::ptrdiff_t>(std::min(spheres, all.size())),
                         all.end(), 0.0);
}

double broken_rate(const Case&, const Replicate& r) {
  return results::share(static_cast<double>(record_of(r).now().broken), r.time());
}

/// [W] (bed.9)
double breakage_power(const Case&, const Replicate& r) {
  return results::share(r.energy_balance.lost_breakage - r.at_settled.lost_breakage, r.time());
}

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.bed_breakage.has_value(); };
  const auto spheres = [](const Case& c) {
    return c.bed_breakage.has_value() && !cases::coarse_grains(c);
  };
  return results::where(
      present, "with `[bed_breakage]`",
      {{"broken_grain_rate",
        "1/s",
        "grains that broke per second",
        broken_rate,
        {.equation = "bed.3", .heading = "Breakage in the bed"}},
       {"bed_d10", "m", "size that 10 % of the mass is finer than, at the end", at_end<10>, {}},
       {"bed_d50", "m", "size that 50 % of the mass is finer than, at the end", at_end<50>, {}},
       {"bed_d90", "m", "size that 90 % of the mass is finer than, at the end", at_end<90>, {}},
       {"fines_share",
        "1",
        "mass share of the particles that are too fine to be simulated, at the end",
        fines_share,
        {.equation = "bed.7", .applies = spheres, .only = "where grains are single particles"}},
       {"breakage_power",
        "W",
        "power that grains take along as they break: stored in their contacts, and the motion of "
        "the fines",
        breakage_power,
        {.equation = "bed.9", .applies = spheres, .only = "where grains are single particles"}}});
}

/// A row at each time: means over the replicates.
Table series(const Outcome& outcome) {
  Table table{{{"time", "s", "time since counting began"},
               {"broken", "1", "grains that have broken since then"},
               {"d10", "m", "size that 10 % of the mass is finer than"},
               {"d50", "m", "size that 50 % of the mass is finer than"},
               {"d90", "m", "size that 90 % of the mass is finer than"}},
              {}};
  const Case& c = outcome.mill_case;
  const auto chosen = results::averaged_replicates(outcome);
  const std::size_t least = results::fewest_over(
      chosen, [](const Replicate& r) { return record_of(r).samples().size(); });
  for (std::size_t i = 0; i < least; ++i) {
    const auto mean = [&](const auto& of) {
      return results::mean_over(chosen,
                                [&](const Replicate& r) { return of(record_of(r).samples()[i]); });
    };
    const auto size = [&](double share) {
      return mean([&](const SizeSample& s) { return quantile_of(c, s, share); });
    };
    table.rows.push_back({record_of(*chosen.front()).samples()[i].time,
                          mean([](const SizeSample& s) { return static_cast<double>(s.broken); }),
                          size(0.1), size(0.5), size(0.9)});
  }
  return table;
}

/// The size distribution at the start of counting and at the end.
Table distribution(const Outcome& outcome) {
  Table table{{{"size", "m", "upper edge of a size class"},
               {"passing_start", "1", "mass share that is finer, when counting began"},
               {"passing", "1", "mass share that is finer, at the end"}},
              {}};
  const auto chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return table;
  const powder::SizeGrid grid = cases::bed_breakage(outcome.mill_case).grid();
  const auto mean = [&](int k, bool end) {
    return results::mean_over(chosen, [&](const Replicate& r) {
      const SizeRecord& record = record_of(r);
      const SizeSample& sample =
          end || record.samples().empty() ? record.now() : record.samples().front();
      const std::vector<double> all = shares(sample);
      return std::accumulate(all.begin() + k, all.end(), 0.0);
    });
  };
  for (int k = 0; k < grid.classes(); ++k)
    table.rows.push_back({grid.upper(k), mean(k, false), mean(k, true)});
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"bed_breakage", "grains that broke and sizes of the powder over time", series(outcome)},
          {"bed_sizes", "size distribution of the powder in the bed", distribution(outcome)}};
}

std::string panel(const Outcome& outcome) {
  const Table sizes = distribution(outcome);
  std::vector<double> size = report::column(sizes, "size");
  for (double& one : size) one *= 1e6;
  return report::figure(
      {.title = "Sizes of the powder in the bed",
       .x = report::Axis{.label = "size (um)", .logarithmic = true},
       .y = report::Axis{.label = "share finer", .least = 0, .most = 1},
       .series = {{"when counting began",
                   size,
                   report::column(sizes, "passing_start"),
                   {},
                   report::Mark::line},
                  {"at the end", size, report::column(sizes, "passing"), {}, report::Mark::line}},
       .shape = 0.42},
      "By mass, from the grains that broke while they moved. bed_sizes.csv has the numbers, "
      "bed_breakage.csv the sizes over time.");
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "bed_breakage",
      .sections = {cases::section_in_case<&Case::bed_breakage, describe>(
          {"bed_breakage", "", "grains of the powder that break while they move"})},
      .check = check,
      .recorder = recorder,
      .quantities = quantities,
      .tables = tables,
      .heading = "Breakage in the bed",
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::bed_breakage
