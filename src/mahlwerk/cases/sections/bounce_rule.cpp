// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The bounce rule of [contact] and of each of [[contact.pairs]].
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/sections/fields.hpp"
#include "mahlwerk/cases/sections/sections.hpp"

namespace mahlwerk::cases {
namespace {

using contact::BounceRule;
using contact::Restitution;
using RestitutionLaw = Restitution::Law;

constexpr double usual_restitution = 0.8;
constexpr Range plausible_restitution{.least = 0.3, .most = 0.9};
constexpr Range plausible_friction{.least = 0.1, .most = 0.6};
constexpr std::string_view clean_metal =
    "clean metal, uncalibrated, range 0.3-0.9 (literature disagrees)";

const NumberSpec& restitution_value() {
  static const NumberSpec spec =
      NumberSpec("restitution", "", restitution_range,
                 "normal speed after a bounce over that before it")
          .with({.label = "coefficient of restitution", .symbol = "$e$", .usual = {"0", "1"}});
  return spec;
}

const NumberSpec& restitution_speed() {
  static const NumberSpec spec("restitution_speed", "m/s", positive,
                               "approach speed at which `restitution` holds");
  return spec;
}

/// One row of a table, speed and value; no value after a fault.
std::optional<std::pair<double, double>> read_row(SectionReader& in, const Node& row) {
  if (row.kind != Node::Kind::list || row.items.size() != 2) {
    in.fault(row, "a row of `restitution_table` must be a speed and a value",
             "write it as [\"1 m/s\", 0.8]", "wrong-type");
    return std::nullopt;
  }
  const double speed = in.quantity(
      row.items[0], {"restitution_table", "m/s", positive, "approach speed, then restitution"});
  const double value = in.quantity(row.items[1], {"restitution_table", "", restitution_range,
                                                  "approach speed, then restitution"});
  if (std::isnan(speed) || std::isnan(value)) return std::nullopt;
  return std::pair{speed, value};
}

std::string table_text(const contact::Restitution& tabulated) {
  std::string rows;
  for (const auto& [speed, value] : tabulated.points())
    rows += fmt::format("{}[{}, {}]", rows.empty() ? "" : ", ", in_quotes(show(speed, "m/s")),
                        shortest(value));
  return "[" + rows + "]";
}

Restitution read_table(SectionReader& in, const Node& at) {
  Restitution::Points points;
  bool sound = at.kind == Node::Kind::list && !at.items.empty();
  if (!sound)
    in.fault(at, "`restitution_table` must be a list of rows",
             "write restitution_table = [[\"0.1 m/s\", 0.9], [\"1 m/s\", 0.75]]", "wrong-type");
  else
    for (const Node& row : at.items) {
      const auto point = read_row(in, row);
      sound = sound && point;
      if (!point) continue;
      if (!points.empty() && point->first <= points.back().first) {
        in.fault(row, "the speeds of `restitution_table` do not increase",
                 "sort the rows by speed, each speed once", "out-of-range");
        sound = false;
      }
      points.push_back(*point);
    }
  if (!sound) return invalid_value;
  const Restitution made = Restitution::tabulated(std::move(points));
  in.record_origin("restitution_table", table_text(made), &at);
  return made;
}

/// The word under `restitution_law`. Its default depends on the other keys that are given.
RestitutionLaw read_law(SectionReader& in, std::string_view given, const Restitution* all) {
  Choice choice{"restitution_law", restitution_laws(), "constant", "the same at every speed"};
  if (given == "restitution_table") {
    choice.standard = "tabulated";
    choice.source = "a restitution_table is given";
  } else if (all != nullptr &&
             !(given == "restitution" && all->law() == RestitutionLaw::tabulated)) {
    choice.standard = restitution_laws()[static_cast<std::size_t>(all->law())];
    choice.source = of_contact;
  }
  return to_enum<RestitutionLaw>(in.choice(choice), restitution_laws());
}

/// A fault for a given key that the law does not use.
void refuse_unused(SectionReader& in, std::string_view key, std::string_view law,
                   const std::string& remedy) {
  in.refuse({key}, fmt::format("under restitution_law = \"{}\"", law), remedy);
}

Restitution read_tabulated(SectionReader& in, const Restitution* all) {
  refuse_unused(in, "restitution_speed", "tabulated", "remove it");
  if (const Node* table = in.find("restitution_table")) return read_table(in, *table);
  if (all != nullptr && all->law() == RestitutionLaw::tabulated) {
    in.record_default("restitution_table", table_text(*all), of_contact);
    return *all;
  }
  in.missing("restitution_table", "approach speeds with their restitution",
             "write restitution_table = [[\"0.1 m/s\", 0.9], [\"1 m/s\", 0.75]]");
  return invalid_value;
}

Restitution read_viscoelastic(SectionReader& in, double value, const Restitution* all) {
  refuse_unused(in, "restitution_table", "viscoelastic", "remove it, or restitution_law");
  NumberSpec speed = restitution_speed();
  if (all != nullptr && all->law() == RestitutionLaw::viscoelastic)
    speed = speed.with_default(all->speed(), of_contact);
  const double at = in.value(speed);
  if (const Node* zero = in.find("restitution"); value == 0 && zero != nullptr)
    in.fault(*zero, "a viscoelastic restitution must be above 0", "give a restitution above 0",
             "out-of-range");
  else if (value == 0)
    in.missing("restitution", "a viscoelastic one must be above 0", "give a restitution above 0");
  return std::isnan(value) || std::isnan(at) || value == 0 ? Restitution(invalid_value)
                                                           : Restitution::viscoelastic(value, at);
}

Restitution read_restitution(SectionReader& in, const Restitution* all) {
  const std::string_view given = in.one_of({"restitution", "restitution_table"});
  const RestitutionLaw law = read_law(in, given, all);
  if (law == RestitutionLaw::tabulated) {
    if (given == "restitution")
      refuse_unused(in, given, "tabulated", "remove it, or restitution_law");
    return read_tabulated(in, all);
  }
  NumberSpec spec = restitution_value()
                        .with_default(usual_restitution, clean_metal)
                        .with_assumed_range(plausible_restitution);
  if (all != nullptr && all->law() != RestitutionLaw::tabulated)
    spec = spec.with_default(all->value(), of_contact);
  const double value = in.value(spec);
  if (law == RestitutionLaw::viscoelastic) return read_viscoelastic(in, value, all);
  if (given == "restitution_table")
    refuse_unused(in, given, "constant", "write restitution_law = \"tabulated\"");
  refuse_unused(in, "restitution_speed", "constant", "write restitution_law = \"viscoelastic\"");
  return value;
}

void describe_restitution(KeyVisitor& v, Restitution& e, const Restitution* all) {
  if (SectionReader* in = v.reader()) {
    e = read_restitution(*in, all);
    return;
  }
  RestitutionLaw law = e.law();
  double value = e.value(), speed = e.speed();
  v.word({"restitution_law",
          restitution_laws(),
          "constant",
          all != nullptr ? of_contact : "the same at every speed",
          "dependence of the restitution on the approach speed",
          {"none", "decreases as that of viscoelastic spheres", "by restitution_table"}},
         law);
  if (law == RestitutionLaw::tabulated)
    v.custom({.key = "restitution_table",
              .about = "approach speeds with their restitution",
              .required = true},
             [&] { return table_text(e); });
  else
    v.number(all != nullptr ? restitution_value().with_default_text(of_contact)
                            : restitution_value().with_default(usual_restitution, clean_metal),
             value);
  if (law == RestitutionLaw::viscoelastic) v.number(restitution_speed(), speed);
}

/// The key `bounce`, "constant" or "walton"; its default depends on the other keys that are given.
Choice bounce_of(KeyVisitor& v, const BounceRule* all) {
  const bool friction = v.gives("friction");
  Choice choice{"bounce",
                {"constant", "walton"},
                "walton",
                "sticking below the Coulomb limit, sliding above it",
                "rule of the tangential velocity in a bounce",
                {"tangential_restitution alone, without friction",
                 "tangential_restitution below the Coulomb limit, sliding above it"}};
  if (!friction && all != nullptr) {
    choice.standard = std::isfinite(all->friction) ? "walton" : "constant";
    choice.source = of_contact;
  } else if (!friction && v.gives("tangential_restitution")) {
    choice.standard = "constant";
    choice.source =
        "tangential_restitution without friction is the rule of Chen et al. 2016, no Coulomb limit";
  }
  return choice;
}

}  // namespace

void describe(KeyVisitor& v, BounceRule& rule, const BounceRule* all) {
  describe_restitution(v, rule.restitution, all ? &all->restitution : nullptr);
  std::size_t walton = rule.friction == std::numeric_limits<double>::infinity() ? 0 : 1;
  if (!v.choose(bounce_of(v, all), walton)) walton = 1;
  NumberSpec tangential(
      "tangential_restitution", "", tangential_range,
      "slip after a bounce over that before it: 1 smooth, 0 no slip, -1 perfectly "
      "rough");
  tangential =
      tangential.read_by(event_only)
          .with({.usual = {"-1", "1"}})
          .with_default(0, walton ? "no slip below the Coulomb limit" : "no slip after a bounce");
  if (all != nullptr) tangential = tangential.with_default(all->tangential_restitution, of_contact);
  v.number(tangential, rule.tangential_restitution);
  if (!walton) {
    v.refuse({"friction"}, "under bounce = \"constant\"",
             "remove friction, or write bounce = \"walton\"");
    return;
  }
  NumberSpec friction =
      NumberSpec("friction", "", not_negative, "Coulomb's friction coefficient mu")
          .with_default(0.3, "uncalibrated, 0.1-0.6")
          .with_assumed_range(plausible_friction)
          .plausible_within("", "3")
          .with({.label = "friction coefficient", .symbol = "$µ$", .usual = {"0", "1"}});
  if (all != nullptr && std::isfinite(all->friction))
    friction = friction.with_default(all->friction, of_contact);
  v.number(friction, rule.friction);
}

}  // namespace mahlwerk::cases
