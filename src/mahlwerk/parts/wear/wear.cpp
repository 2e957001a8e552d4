// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/wear/wear.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>

#include "mahlwerk/cases/file/key_visitor.hpp"
#include "mahlwerk/cases/pairs.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/powder/wear.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::parts::wear {
namespace {

using cases::Case;
using results::Outcome;
using results::Replicate;
using results::Table;

void describe(cases::KeyVisitor& v, Wear& wear, const Case&) {
  v.word({"model",
          {"archard", "finnie"},
          "archard",
          "by normal force and sliding distance",
          "wear model",
          {"wear by normal force and sliding distance (wea.1)",
           "wear by energy and angle of each impact (wea.4)"}},
         wear.model);
  v.number({"coefficient", "", positive, "worn volume times hardness over force times distance",
            Wear().coefficient,
            wear.model == Wear::Model::finnie
                ? "as much as Archard's at grazing impacts (wea.5); uncalibrated"
                : "uncalibrated, 1e-6 to 1e-2"},
           wear.coefficient);
}

bool wears(const Case& c) {
  return c.parts.find<Wear>() != nullptr;
}

/// Volume [m3], or [m3/s] for rates, worn off a body of a Vickers hardness.
double worn(const Case& c, double slid, double erosion, double vickers) {
  const Wear& wear = *c.parts.find<Wear>();
  const double hardness = powder::hardness(vickers);
  return wear.model == Wear::Model::archard ? powder::archard(wear.coefficient, slid, hardness)
                                            : wear.coefficient * erosion / hardness;  // (wea.4)
}

/// [m3/s] Wear of the balls of one set. Grains are powder and do not wear.
double set_wear_rate(const Case& c, const Replicate& r, int set) {
  const cases::BallSet& balls = c.balls[static_cast<std::size_t>(set)];
  if (balls.grains) return 0;
  double slid = 0, erosion = 0;
  const observe::StatisticsByPair& pairs = r.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto [one, other] = pairs.kinds_of(pair);
    const int times = (one == set ? 1 : 0) + (other == set ? 1 : 0);  // both balls wear
    slid += times * pairs[pair].load_distance;
    erosion += times * pairs[pair].erosion;
  }
  return worn(c, slid, erosion, balls.substance.hardness) / r.time();
}

/// What wears at a distinguished face: the jar or a part.
struct WallMaterial {
  double hardness, density;
};
WallMaterial wall_material(const Case& c, const Replicate& r, int face) {
  const cases::MachinePart* part = results::part_of(c, r.tally.by_pair, face);
  return part != nullptr ? WallMaterial{part->substance.hardness, part->density}
                         : WallMaterial{c.jar.substance.hardness, c.jar.density};
}

/// [m3/s] Wear of one distinguished face.
double face_wear_rate(const Case& c, const Replicate& r, int face) {
  double slid = 0, erosion = 0;
  const observe::StatisticsByPair& pairs = r.tally.by_pair;
  for (int pair = 0; pair < pairs.pairs(); ++pair) {
    const auto kinds = pairs.kinds_of(pair);
    if (!kinds.with_jar() || kinds.face() != face) continue;
    slid += pairs[pair].load_distance;
    erosion += pairs[pair].erosion;
  }
  return worn(c, slid / r.time(), erosion / r.time(), wall_material(c, r, face).hardness);
}
/// [kg/s] of the distinguished faces from `first` to before `last`.
double faces_wear(const Case& c, const Replicate& r, int first, int last) {
  double mass = 0;
  for (int face = first; face < last; ++face)
    mass += face_wear_rate(c, r, face) * wall_material(c, r, face).density;
  return mass;
}

double balls_wear(const Case& c, const Replicate& r) {
  double mass = 0;
  for (int set = 0; set < std::ssize(c.balls); ++set)
    mass += set_wear_rate(c, r, set) * c.balls[static_cast<std::size_t>(set)].surface_density();
  return mass;
}
double jar_wear(const Case& c, const Replicate& r) {
  return faces_wear(c, r, 0, results::distinguished_jar_faces(c, r.tally.by_pair));
}
double parts_wear(const Case& c, const Replicate& r) {
  return faces_wear(c, r, results::distinguished_jar_faces(c, r.tally.by_pair),
                    r.tally.by_pair.faces());
}

results::Measures quantities() {
  const auto weighed_powder = [](const Case& c) { return c.powder && c.powder->mass > 0; };
  return results::where(
      wears, "with `[wear]`",
      {{"wear_rate_balls",
        "kg/s",
        "mass worn off all balls per second",
        balls_wear,
        {.label = "wear rate of the balls", .heading = "Wear"}},
       {"wear_rate_jar",
        "kg/s",
        "mass worn off the jar per second",
        jar_wear,
        {.label = "wear rate of the jar"}},
       {"wear_rate_parts",
        "kg/s",
        "mass worn off the parts in the jar per second",
        parts_wear,
        {.label = "wear rate of the parts",
         .applies = [](const Case& c) { return !c.machine_parts.empty(); },
         .only = "with `[[parts]]`"}},
       {"contamination_rate",
        "ug/g/h",
        "worn mass of balls, jar and parts per mass of powder and hour of milling",
        [](const Case& c, const Replicate& r) {
          constexpr double hour = 3600;
          return 1e6 * hour * (balls_wear(c, r) + jar_wear(c, r) + parts_wear(c, r)) /
                 c.powder->mass;
        },
        {.key = 11, .applies = weighed_powder, .only = "with `[powder]`"}}});
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
          [&](const Replicate& r) { return set_wear_rate(c, r, set); });
  for (int pair = 0; pair < pairs.pairs(); ++pair)
    if (const auto kinds = pairs.kinds_of(pair); kinds.one == 0 && kinds.with_jar())
      add(results::pair_names(c, pairs, pair)[1],
          wall_material(c, *chosen.front(), kinds.face()).density,
          [&](const Replicate& r) { return face_wear_rate(c, r, kinds.face()); });
  return table;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {{"wear", "wear of balls and jar", rates(outcome)}};
}

std::vector<results::WallColumn> wall_columns() {
  return {{{"wear_depth_rate", "m/s", "depth of wall worn off per second"},
           [](const Case& of, const results::HitRates& rates, std::size_t cell, double hardness) {
             if (!(rates.area[cell] > 0)) return 0.0;
             return worn(of, rates.slid[cell], rates.erosion[cell], hardness) / rates.area[cell];
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

bool needs(const Case&, std::string_view key) {
  return key.ends_with("hardness") || key == "jar.density";
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{.name = "wear",
                                .sections = {cases::section_of<Wear, describe>(
                                    {"wear", "model", "wear of balls and jar; may be empty"})},
                                .needs = needs,
                                .quantities = quantities,
                                .tables = tables,
                                .wall_columns = wall_columns,
                                .heading = "Wear",
                                .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::wear
