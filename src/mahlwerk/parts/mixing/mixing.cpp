// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/mixing/mixing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/observe/approach.hpp"
#include "mahlwerk/parts/mixing/mixing_record.hpp"
#include "mahlwerk/parts/mixing/tables.hpp"
#include "mahlwerk/report/columns.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::parts::mixing {
namespace {

using cases::Case;
using results::Outcome;
using results::Replicate;
using results::Table;

constexpr double most_samples = 1000;

const Mixing& section_of_case(const Case& c) {
  return *c.parts.find<Mixing>();
}

double usual_balls_per_cell(const Case& c) {
  const double usual = Mixing().balls_per_cell;
  const auto balls = static_cast<double>(cases::balls_count(c.balls));
  return balls > 0 ? std::clamp(balls, 2.0, usual) : usual;
}

void describe(cases::KeyVisitor& v, Mixing& mixing, const Case& c) {
  const bool several = c.balls.size() > 1;
  v.word({"colour",
          {"sets", "across", "height", "axis", "radius"},
          several || v.visits_all() ? "sets" : "height",
          "the sets of the case; of one set its lower and upper half",
          "which balls have the two colours when counting begins",
          {"the first ball set and all others",
           "two halves side by side, level and across the axis", "the lower and the upper half",
           "two halves along the jar's axis", "the inner and the outer half"}},
         mixing.colour);
  v.number({"balls_per_cell",
            "",
            {.least = 2, .most = 1e6},
            "balls in a full cell of Lacey's index",
            usual_balls_per_cell(c),
            "usual: 10 to 50; at most all balls"},
           mixing.balls_per_cell);
  v.optional_number(cases::NumberSpec("interval", "s", positive, "time between two samples")
                        .with_default_text("a hundredth of the counted time"),
                    mixing.interval);
}

double interval_of(const Case& c) {
  return section_of_case(c).interval.value_or(cases::counted_time(c) / 100);
}

void check(const Case& c, std::vector<Fault>& found) {
  const Mixing& m = section_of_case(c);
  if (m.colour == Mixing::Colour::sets && c.balls.size() < 2)
    found.push_back(
        {cases::location_of(c, "mixing.colour"),
         "colour = \"sets\": the case has one ball set, of one colour",
         "give two ball sets, or colour = \"height\", \"across\", \"axis\" or \"radius\"",
         "one-colour"});
  if (cases::balls_count(c.balls) < 2)
    found.push_back({cases::location_of(c, "mixing.colour"), "one ball has no degree of mixing",
                     "remove [mixing], or give more balls", "one-colour"});
  else if (m.balls_per_cell > static_cast<double>(cases::balls_count(c.balls)))
    found.push_back(
        {cases::location_of(c, "mixing.balls_per_cell"),
         fmt::format(
             "balls_per_cell = {} is more than the {} balls of the case: all would be in one "
             "cell, which has no degree of mixing",
             show_rounded(m.balls_per_cell, ""), cases::balls_count(c.balls)),
         "write a smaller balls_per_cell, usually 10 to 50, or give more balls", "cell-too-large"});
  if (m.interval && *m.interval > cases::counted_time(c))
    found.push_back(
        {cases::location_of(c, "mixing.interval"),
         fmt::format("an interval of {} is longer than the counted time ({})",
                     show_rounded(*m.interval, "s"), show_rounded(cases::counted_time(c), "s")),
         "give a shorter interval, or leave it out", "too-few-readings"});
  const double least = cases::counted_time(c) / most_samples;
  if (m.interval && *m.interval < least * (1 - 1e-9))
    found.push_back({cases::location_of(c, "mixing.interval"),
                     fmt::format("a sample every {} makes more than {} of the mixing",
                                 show_rounded(*m.interval, "s"), most_samples),
                     fmt::format("write interval = \"{}\" or more, or leave it out",
                                 show_rounded(1.05 * least, "s")),
                     "too-many-readings"});
}

std::unique_ptr<observe::Recorder> recorder(const Case& c) {
  double volume = 0, count = 0;
  for (const cases::BallSet& set : c.balls) {
    volume += static_cast<double>(set.count) * cases::ball_volume(set);
    count += static_cast<double>(set.count);
  }
  const double mean = volume / count, d = math::cbrt(6 * mean / std::numbers::pi);
  constexpr double packing = 0.6, neighbours = 1.5;
  scene::Chamber mill = cases::chamber(c);
  if (c.drive) mill.motion = c.mill.motion;  // each run has a drive of its own
  return std::make_unique<MixingRecord>(
      MixingSetup{.section = section_of_case(c),
                  .mill = std::move(mill),
                  .driven = c.drive ? std::abs(cases::speed_without_load(c)) : 0,
                  .interval = interval_of(c),
                  .cell = math::cbrt(section_of_case(c).balls_per_cell * mean / packing),
                  .reach = neighbours * d,
                  .diameter = d,
                  .flows = c.flow.has_value()});
}

/// Mean of a member over the second half of the samples.
double late(const Replicate& r, double MixingSample::*member) {
  const auto& all = samples_of(r);
  double sum = 0, count = 0;
  for (std::size_t i = all.size() / 2; i < all.size(); ++i)
    if (std::isfinite(all[i].*member)) sum += all[i].*member, ++count;
  return results::share(sum, count);
}

/// The approach of the neighbour mixing index to its end (mix.3).
observe::Approach approach(const Replicate& r) {
  std::vector<double> times, values;
  for (const MixingSample& s : samples_of(r)) {
    times.push_back(s.time);
    values.push_back(s.neighbours);
  }
  return observe::fit_approach(times, values);
}

/// [m2/s] Half the slope of the mean square way along the axis, by the second half (mix.6).
double axial_dispersion(const Replicate& r) {
  const auto& all = samples_of(r);
  const std::size_t from = all.size() / 2;
  if (all.size() < 4) return results::undefined;
  return 0.5 * (all.back().axial_spread - all[from].axial_spread) /
         (all.back().time - all[from].time);
}

template <double MixingSample::*member>
double late_mean(const Case&, const Replicate& r) {
  return late(r, member);
}

results::Measures quantities() {
  const auto present = [](const Case& c) { return c.parts.find<Mixing>() != nullptr; };
  return results::where(
      present, "with `[mixing]`",
      {{"lacey_index",
        "1",
        "Lacey's mixing index of the second half of the counted time: 0 separated, 1 as at random",
        late_mean<&MixingSample::lacey>,
        {.range = results::any_value, .equation = "mix.1", .heading = "Mixing"}},
       {"neighbour_mixing_index",
        "1",
        "share of neighbours of the other colour over that of a random mixture, likewise",
        late_mean<&MixingSample::neighbours>,
        {.equation = "mix.2"}},
       {"mixing_time",
        "s",
        "time constant of an exponential approach of the neighbour mixing index to its end value",
        [](const Case&, const Replicate& r) { return approach(r).time; },
        {.equation = "mix.3"}},
       {"segregation_radial",
        "1",
        "how much farther from the axis the first colour is, over the spread of all balls",
        late_mean<&MixingSample::radial>,
        {.range = results::any_value, .equation = "mix.4"}},
       {"segregation_vertical",
        "1",
        "how much higher the first colour is, over the spread of all balls",
        late_mean<&MixingSample::vertical>,
        {.range = results::any_value, .equation = "mix.4"}},
       {"segregation_axial",
        "1",
        "how much farther along the jar's axis the first colour is, over the spread of all balls; "
        "none in a jar that is periodic along it",
        late_mean<&MixingSample::axial>,
        {.range = results::any_value, .equation = "mix.4"}},
       {"packing_fraction",
        "1",
        "mean packing fraction in the bed, clear of walls, parts and surface; none in a bed too "
        "shallow for it",
        late_mean<&MixingSample::packing>,
        {.equation = "mix.5"}},
       {"bed_porosity",
        "1",
        "one minus the packing fraction",
        [](const Case&, const Replicate& r) { return 1 - late(r, &MixingSample::packing); },
        {.range = results::any_value, .equation = "mix.5"}},
       {"bed_height",
        "m",
        "height of all but the highest 2 % of the balls above the lowest",
        late_mean<&MixingSample::bed_height>,
        {}},
       {"axial_dispersion",
        "m2/s",
        "half the growth of the mean square way of the balls along the jar's axis, per time",
        [](const Case&, const Replicate& r) { return axial_dispersion(r); },
        {.range = results::any_value,
         .equation = "mix.6",
         .applies = [](const Case& c) { return !c.flow; },
         .only = "without `[flow]`"}}});
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  std::vector<results::NamedTable> all{
      {"mixing", "mixing, segregation and packing of the charge over time", series(outcome)}};
  if (Table profile = packing_profile(outcome); !profile.rows.empty())
    all.push_back({"packing_profile",
                   "packing fraction in the bed against height, of the second half of the counted "
                   "time",
                   std::move(profile)});
  return all;
}

Notices notices(const Outcome& outcome) {
  using Kind = observe::Approach::Kind;
  const auto chosen = results::averaged_replicates(outcome);
  std::size_t open = 0, early = 0;
  for (const Replicate* r : chosen) {
    const observe::Approach found = approach(*r);
    // Without a change, the halves of a charge that does not mix look like one that is mixed.
    constexpr double half_mixed = 0.5;
    const bool unmixed = found.kind == Kind::flat && !(found.end > half_mixed);
    if (found.kind == Kind::open || unmixed)
      ++open;
    else if (found.kind != Kind::found)
      ++early;
  }
  const auto share = [&](std::size_t of) {
    return chosen.size() == 1 ? std::string("The charge")
                              : fmt::format("The charge of {} of {} replicates", of, chosen.size());
  };
  Notices all;
  if (open > 0)
    all.push_back(warning(
        "not-mixed", share(open) +
                         " has not come to an end of its mixing within the counted time, or has "
                         "not begun to mix: it has no mixing time. mixing.csv has the index over "
                         "time; a longer run.time tells."));
  if (early > 0)
    all.push_back(note("mixed-from-start",
                       share(early) +
                           " is as mixed as it becomes from the first sample, or from the second: "
                           "it has no mixing time. To see it mix, count from the start "
                           "(run.settle = \"0 s\") or shorten mixing.interval."));
  const auto has_packing = [](const Replicate* r) {
    return std::isfinite(late(*r, &MixingSample::packing));
  };
  if (std::ranges::none_of(chosen, has_packing))
    all.push_back(
        note("no-packing-fraction",
             "packing_fraction and bed_porosity have no value: no place in the bed is two "
             "ball diameters away from walls, parts and surface. A bed at least five "
             "diameters deep and wide, with balls that lie, has them."));
  return all;
}

std::string panel(const Outcome& outcome) {
  const Table table = series(outcome);
  const std::vector<double> time = report::column(table, "time");
  return report::figure(
      {.title = "Mixing",
       .x = report::Axis{.label = "time (s)", .least = 0},
       .y = report::Axis{.label = "mixing index", .least = 0},
       .series = {{"Lacey", time, report::column(table, "lacey_index"), {}, report::Mark::line},
                  {"neighbours",
                   time,
                   report::column(table, "neighbour_mixing_index"),
                   {},
                   report::Mark::line}},
       .shape = 0.42},
      "0: the two colours are apart, 1: as in a random mixture. mixing.csv has the numbers, and "
      "those of segregation and packing.");
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "mixing",
      .sections = {cases::section_of<Mixing, describe>(
          {"mixing", "", "how fast the charge mixes, and how it is packed; may be empty"})},
      .check = check,
      .recorder = recorder,
      .quantities = quantities,
      .tables = tables,
      .notices = notices,
      .heading = "Mixing",
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::mixing
