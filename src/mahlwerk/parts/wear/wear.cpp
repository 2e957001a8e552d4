// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/wear.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/wall.hpp"
#include "mahlwerk/results/quantities/wear_rates.hpp"

namespace mahlwerk::parts::wear {
namespace {

using cases::Case;
using cases::Wear;
using results::Outcome;
using results::Replicate;
using results::Table;

/// [1] Of the largest balls: the default of scrap_size.
constexpr double scrap_share = 0.25;

/// Keys of the change of shapes and sizes with time.
void describe_evolution(cases::KeyVisitor& v, Wear& wear, const Case& c) {
  const cases::NumberSpec evolve(
      "evolve", "s", positive,
      "time of operation over which shapes and ball sizes follow their wear, in stages; left out: "
      "they stay as they are");
  v.optional_number(evolve, wear.evolve);
  if (!wear.evolve && !v.visits_all())
    return v.refuse({"largest_change", "worn_out", "make_up", "scrap_size"}, "without `evolve`",
                    "add for instance evolve = \"500 h\"");
  v.number({"largest_change",
            "",
            {.least = 0, .most = 0.5, .without_least = true},
            "movement of a profile over its height, and of a ball's diameter over that of a fresh "
            "one, after which the next stage begins",
            Wear().largest_change,
            "stages are of first order in it: halve it to see their error"},
           wear.largest_change);
  v.number({"worn_out",
            "",
            {.least = 0, .most = 1, .without_least = true},
            "share of the height of a profile whose loss ends its life",
            Wear().worn_out,
            "half of the height"},
           wear.worn_out);
  v.flag({"make_up", Wear().make_up, "no balls are added",
          "whether fresh balls, as large as the largest of their set, replace the volume that a "
          "set loses"},
         wear.make_up);
  const double largest = cases::largest_ball(c.balls);
  const cases::NumberSpec scrap("scrap_size", "m", not_negative, "balls below it leave the jar");
  v.number(largest > 0 ? scrap.with_default(scrap_share * largest, "a quarter of the largest ball")
                       : scrap.with_default_text("a quarter of the largest ball"),
           wear.scrap_size);
}

void describe(cases::KeyVisitor& v, Wear& wear, const Case& c) {
  v.word({"model",
          {"archard", "finnie", "energy"},
          "archard",
          "by normal force and sliding distance",
          "wear model",
          {"wear by normal force and sliding distance (wea.1)",
           "wear by energy and angle of each impact (wea.4)",
           "wear by the energy that contacts lose (wea.8)"}},
         wear.model);
  v.number(
      {"coefficient", "", positive,
       "worn volume times hardness over force times distance, or over energy", Wear().coefficient,
       wear.model == Wear::Model::finnie
           ? "as much as Archard's at grazing impacts (wea.5); uncalibrated"
           : "uncalibrated, 1e-6 to 1e-2"},
      wear.coefficient);
  describe_evolution(v, wear, c);
}

bool wears(const Case& c) {
  return c.parts.find<Wear>() != nullptr;
}

/// [kg/s] Of balls, jar and parts.
double all_wear(const Case& c, const Replicate& r) {
  return results::balls_wear(c, r) + results::jar_wear(c, r) + results::parts_wear(c, r);
}

/// [kg] Worn off over the milling time.
double worn_mass(const Case& c, const Replicate& r) {
  return all_wear(c, r) * *cases::milling_time(c);
}

results::Measures quantities() {
  const auto timed = [](const Case& c) { return cases::milling_time(c).has_value(); };
  const auto weighed_powder = [](const Case& c) { return c.powder && c.powder->mass > 0; };
  return results::where(
      wears, "with `[wear]`",
      {{"wear_rate_balls",
        "kg/s",
        "mass worn off all balls per second",
        results::balls_wear,
        {.label = "wear rate of the balls", .heading = "Wear"}},
       {"wear_rate_jar",
        "kg/s",
        "mass worn off the jar per second",
        results::jar_wear,
        {.label = "wear rate of the jar"}},
       {"wear_rate_parts",
        "kg/s",
        "mass worn off the parts in the jar per second",
        results::parts_wear,
        {.label = "wear rate of the parts",
         .applies = [](const Case& c) { return !c.machine_parts.empty(); },
         .only = "with `[[parts]]`"}},
       {"contamination_rate",
        "ug/g/h",
        "worn mass of balls, jar and parts per mass of powder and hour of milling",
        [](const Case& c, const Replicate& r) {
          constexpr double hour = 3600;
          return 1e6 * hour * all_wear(c, r) / c.powder->mass;
        },
        {.key = 11, .applies = weighed_powder, .only = "with `[powder]`"}},
       {"worn_mass",
        "kg",
        "mass worn off balls, jar and parts over the milling time",
        worn_mass,
        {.applies = timed, .only = "if the case gives a milling time"}},
       {"contamination",
        "mg/kg",
        "worn mass of balls, jar and parts over the milling time, per mass of powder",
        [](const Case& c, const Replicate& r) { return 1e6 * worn_mass(c, r) / c.powder->mass; },
        {.applies =
             [](const Case& c) { return cases::milling_time(c) && c.powder && c.powder->mass > 0; },
         .only = "with `[powder]`, if the case gives a milling time"}}});
}

/// A row for each ball set, each face of the jar and each part.
Table rates(const Outcome& outcome) {
  Table table{{{"body", "1", "a ball set, the jar or a face of it, or a part"},
               {"volume_rate", "m3/s", "volume worn off it per second"},
               {"mass_rate", "kg/s", "mass worn off it per second"}},
              {}};
  const Case& c = outcome.mill_case;
  const auto chosen = results::averaged_replicates(outcome);
  if (chosen.empty()) return table;
  const auto add = [&](const std::string& name, double density, const auto& of) {
    double volume = 0;
    for (const Replicate* r : chosen) volume += of(*r) / static_cast<double>(chosen.size());
    table.rows.push_back({table.columns[0].number_of(name), volume, volume * density});
  };
  const observe::StatisticsByPair& pairs = chosen.front()->tally.by_pair;
  for (int set = 0; set < pairs.kinds(); ++set)
    if (const auto i = static_cast<std::size_t>(set); !c.balls[i].grains)
      add(cases::set_name(c, i), c.balls[i].surface_density(),
          [&](const Replicate& r) { return results::set_wear_rate(c, r, set); });
  for (int pair = 0; pair < pairs.pairs(); ++pair)
    if (const auto kinds = pairs.kinds_of(pair); kinds.one == 0 && kinds.with_jar())
      add(results::pair_names(c, pairs, pair)[1],
          results::wall_material(c, *chosen.front(), kinds.face()).density,
          [&](const Replicate& r) { return results::face_wear_rate(c, r, kinds.face()); });
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"wear", "wear of balls and jar", rates(outcome)}};
}

std::vector<results::WallColumn> wall_columns() {
  return {{{"wear_depth_rate", "m/s", "depth of wall worn off per second"},
           [](const Case& of, const results::HitRates& rates, std::size_t cell, double hardness) {
             if (!(rates.area[cell] > 0)) return 0.0;
             const cases::ContactSums sums{rates.slid[cell], rates.erosion[cell], rates.lost[cell]};
             return cases::worn_volume(*of.parts.find<Wear>(), sums, hardness) / rates.area[cell];
           }}};
}

std::string panel(const Outcome& outcome) {
  const Table table = rates(outcome);
  if (table.rows.empty()) return "";
  std::string body;
  for (const auto& row : table.rows)
    body +=
        fmt::format("<tr><th scope=\"row\">{}</th><td class=\"n\">{}</td></tr>\n",
                    report::escaped(table.columns[0].words[static_cast<std::size_t>(row[0])]),
                    report::escaped(report::readable(row[2], std::nan(""), "kg/s", row[2]).text()));
  return fmt::format(
      "<div class=\"wide\"><table>\n<thead><tr><th></th><th class=\"n\">wear rate"
      "</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div>\n<p><small>From the wear "
      "coefficient of the case, which is rarely known better than to a factor of "
      "ten.</small></p>\n",
      body);
}

/// What keeps shapes and sizes from following the wear.
void check(const Case& c, std::vector<Fault>& found) {
  if (!c.parts.find<Wear>()->evolve) return;
  const auto refuse = [&](bool wrong, const char* what, const char* remedy) {
    if (wrong)
      found.push_back({cases::location_of(c, "wear.evolve"), what, remedy, "no-wear-evolution"});
  };
  refuse(!c.sweep.empty() || c.optimise || c.match || c.uncertainty || !c.fit.empty(),
         "wear over time is computed for one case: it goes with no sweep, search, fit or "
         "uncertainty",
         "remove `evolve`, or that section");
  refuse(c.run.engine == cases::EngineName::lammps,
         "engine = \"lammps\" computes no wear over time",
         "write engine = \"soft\" or \"auto\", or remove `evolve`");
  refuse(c.flow.has_value(), "balls that flow through the jar do not wear down in it",
         "remove [flow] or `evolve`");
  refuse(c.run.start_from.states != nullptr,
         "a state of the start has balls of given sizes, which would change",
         "remove run.start_from or `evolve`");
  refuse(c.observe.collisions || c.observe.frames.has_value(),
         "records of every collision and frames are kept for one run, not for the stages of wear",
         "remove them from [observe], or remove `evolve`");
  const auto some_balls = [&](auto is) { return std::ranges::any_of(c.balls, is); };
  refuse(some_balls([](const cases::BallSet& set) {
           return !set.grains && (set.wall_thickness || set.coating_thickness);
         }),
         "hollow or coated balls change their density as they wear",
         "give solid balls, or remove `evolve`");
  refuse(some_balls([](const cases::BallSet& set) { return !set.positions.empty(); }),
         "given positions are those of balls that keep their size",
         "give the number of balls by count, mass or filling, or remove `evolve`");
  refuse(
      std::ranges::any_of(c.contact.pairs,
                          [](const cases::PairRule& rule) {
                            return std::ranges::any_of(rule.between, [](const std::string& name) {
                              return name.starts_with("balls.") || name.starts_with("jar.lifter");
                            });
                          }),
      "[[contact.pairs]] names a ball set or a lifter: sets are divided by size as they wear, "
      "and lifters are one part",
      "write \"balls\", \"jar\" or the name of a material");
}

bool needs(const Case&, std::string_view key) {
  return key.ends_with("hardness") || key == "jar.density";
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{.name = "wear",
                                .sections = {cases::section_of<Wear, describe>(
                                    {"wear", "model", "wear of balls and jar; may be empty"})},
                                .check = check,
                                .needs = needs,
                                .quantities = quantities,
                                .tables = tables,
                                .wall_columns = wall_columns,
                                .heading = "Wear",
                                .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::wear
