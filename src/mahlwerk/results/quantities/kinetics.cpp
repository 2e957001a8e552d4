// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/kinetics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/cases/wear_heat.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/heat_share.hpp"
#include "mahlwerk/results/quantities/wall.hpp"

namespace mahlwerk::results {
namespace {

using cases::Case;
using powder::ImpactKinetics;
using Chosen = std::vector<const Replicate*>;

powder::PowderTemperature powder_temperature(const Case& mill_case, const Chosen& of) {
  const cases::Kinetics& k = *mill_case.kinetics;
  powder::PowderTemperature found;
  found.from_heat = !k.temperature;
  if (k.temperature) {
    found.constant = *k.temperature;
    return found;
  }
  found.nodes = cases::heat_nodes(mill_case, wall_area(*mill_case.jar.shape));
  found.cycles = cases::mill_cycles(
      mill_case, mean_over(of, [](const Replicate& r) { return dissipated_power(r); }),
      mean_over(of, [&](const Replicate& r) { return heat_share_in_balls(mill_case, r); }));
  found.node = k.temperature_of == cases::Kinetics::TemperatureOf::balls
                   ? powder::PowderTemperature::Node::balls
                   : powder::PowderTemperature::Node::jar;
  return found;
}

std::vector<powder::PowderHits> powder_hits(const Case& mill_case,
                                            const powder::StressSpectrum& stresses) {
  std::vector<powder::PowderHits> hits;
  if (!mill_case.capture) {
    for (const powder::Stress& s : stresses.stresses)
      hits.push_back({s.energy, s.rate, *mill_case.kinetics->mass_per_hit});
    return hits;
  }
  const powder::Process process = cases::process(mill_case);
  const powder::Grain grain = process.grain(*mill_case.powder->size);
  for (const powder::Stress& s : stresses.stresses) {
    const powder::Capture c = process.capture_per_hit(
        stresses.nips[static_cast<std::size_t>(s.nip)], s.energy, grain.size);
    hits.push_back({s.energy, s.rate, c.mean_mass(grain)});
  }
  return hits;
}

}  // namespace

bool kinetics_reads_hits(const Case& mill_case) {
  return mill_case.kinetics && powder::reads_hits(*mill_case.kinetics->model);
}

powder::MillingConditions milling_conditions(const Case& mill_case, const Chosen& of,
                                             const powder::StressSpectrum& stresses) {
  powder::MillingConditions mill;
  mill.powder_mass = mill_case.powder->mass;
  mill.dose_rate = dose_rate(mill_case, of, stresses);
  mill.impact_rate = mean_over(
      of, [](const Replicate& r) { return static_cast<double>(r.tally.above.count) / r.time(); });
  if (kinetics_reads_hits(mill_case)) mill.hits = powder_hits(mill_case, stresses);
  if (powder::reads_temperature(*mill_case.kinetics->model))
    mill.temperature = powder_temperature(mill_case, of);
  return mill;
}

double ignition_time(const Case& mill_case, const powder::MillingConditions& mill) {
  constexpr double far = 10;
  const auto* model = std::get_if<powder::IgnitionKinetics>(&*mill_case.kinetics->model);
  return model == nullptr ? undefined : model->ignition_time(mill, far * mill_case.kinetics->time);
}

namespace {

powder::ReactionShares shares_at_end(const Case& c, const Replicate& r) {
  if (!r.grinding) return {undefined, undefined, undefined};
  return powder::reaction_shares(*c.kinetics->model, r.grinding->conditions, c.kinetics->time);
}

/// [J/kg] Dose over the milling time.
double milling_dose(const Case& c, const Replicate& r) {
  return r.grinding ? r.grinding->dose_rate * c.kinetics->time : undefined;
}

powder::ImpactRates impact_rates(const Case& c, const Replicate& r) {
  return std::get<ImpactKinetics>(*c.kinetics->model).rates(r.grinding->conditions);
}

/// Of a case with model = "by-impact", in the units that papers print.
bool by_hits(const Case& c) {
  return powder::reads_hits(*c.kinetics->model);
}
bool of_two_products(const Case& c) {
  return powder::has_second_product(*c.kinetics->model);
}
bool ignites(const Case& c) {
  return std::holds_alternative<powder::IgnitionKinetics>(*c.kinetics->model);
}

/// The impact rates of a replicate, or NaN without any.
template <class Of>
double of_impacts(const Case& c, const Replicate& r, const Of& of) {
  return r.grinding ? of(impact_rates(c, r)) : undefined;
}

Measures reaction_measures() {
  return {
      {"milling_dose",
       "J/g",
       "energy by mass of powder over the milling time",
       [](const Case& c, const Replicate& r) { return milling_dose(c, r) / 1000; },
       {.heading = "Dose"}},
      {"milling_dose_per_mole",
       "kJ/mol",
       "energy by amount of powder, likewise",
       [](const Case& c, const Replicate& r) {
         return milling_dose(c, r) * *c.kinetics->molar_mass / 1000;
       },
       {.applies = [](const Case& c) { return c.kinetics->molar_mass.has_value(); },
        .only = "and `molar_mass`"}},
      {"conversion",
       "1",
       "conversion after milling, by [kinetics]",
       [](const Case& c, const Replicate& r) { return shares_at_end(c, r).conversion; },
       {.range = share_of_whole, .symbol = "$X$", .key = 10, .column = 3}},
      {"yield",
       "1",
       "share of the first product, after milling",
       [](const Case& c, const Replicate& r) { return shares_at_end(c, r).product; },
       {.range = share_of_whole, .applies = of_two_products, .only = "with two reactions"}},
      {"second_yield",
       "1",
       "share of the second product, after milling",
       [](const Case& c, const Replicate& r) { return shares_at_end(c, r).second_product; },
       {.range = share_of_whole, .applies = of_two_products, .only = "with two reactions"}},
  };
}

Measures impact_measures() {
  return {
      {"processing_hit_rate",
       "1/s",
       "hits per second that process powder",
       [](const Case& c, const Replicate& r) {
         return of_impacts(c, r, [](const powder::ImpactRates& i) { return i.hits; });
       },
       {.applies = by_hits, .only = "under `model = \"by-impact\"`"}},
      {"processing_hit_energy",
       "J",
       "mean energy of the hits that process powder",
       [](const Case& c, const Replicate& r) {
         return of_impacts(c, r,
                           [](const powder::ImpactRates& i) { return share(i.power, i.hits); });
       },
       {.applies = by_hits, .only = "under `model = \"by-impact\"`"}},
      {"processed_mass_per_hit",
       "kg",
       "mean mass of powder that such a hit processes",
       [](const Case& c, const Replicate& r) {
         return of_impacts(c, r,
                           [](const powder::ImpactRates& i) { return share(i.mass, i.hits); });
       },
       {.applies = by_hits, .only = "under `model = \"by-impact\"`"}},
      {"processed_share_per_hit",
       "1",
       "k: that mass over the mass of the powder",
       [](const Case& c, const Replicate& r) {
         return of_impacts(c, r, [&](const powder::ImpactRates& i) {
           return share(i.mass, i.hits * c.powder->mass);
         });
       },
       {.range = share_of_whole, .applies = by_hits, .only = "under `model = \"by-impact\"`"}},
      {"processing_rate",
       "1/s",
       "how often hits process each part of the reactant, per second",
       [](const Case& c, const Replicate& r) {
         return of_impacts(c, r, [](const powder::ImpactRates& i) { return i.first; });
       },
       {.applies = by_hits, .only = "under `model = \"by-impact\"`"}},
      {"ignition_time",
       "s",
       "milling time until the powder ignites",
       [](const Case& c, const Replicate& r) {
         const double time = r.grinding ? ignition_time(c, r.grinding->conditions) : undefined;
         return std::isfinite(time) ? time : undefined;
       },
       {.equation = "rea.8", .applies = ignites, .only = "under `model = \"ignition\"`"}},
      {"property",
       "1",
       "property of the powder ([kinetics] property), after milling",
       [](const Case& c, const Replicate& r) {
         if (!r.grinding) return undefined;
         return std::lerp(c.kinetics->initial, c.kinetics->final, shares_at_end(c, r).conversion);
       },
       {.range = any_value,
        .applies = [](const Case& c) { return !c.kinetics->property.empty(); },
        .only = "and `property`",
        .about = [](const Case& c) { return c.kinetics->property + ", after milling"; }}},
  };
}

}  // namespace

Measures kinetics_measures() {
  Measures list = reaction_measures();
  std::ranges::move(impact_measures(), std::back_inserter(list));
  return where([](const Case& c) { return c.kinetics.has_value(); }, "with `[kinetics]`",
               std::move(list));
}

Table conversion(const Outcome& outcome) {
  Table table{{{"time", "s", "milling time"},
               {"dose", "J/g", "energy by mass of powder until then"},
               {"conversion", "1", "conversion by then"}},
              {}};
  const Chosen chosen = grinding_replicates(outcome);
  if (!outcome.mill_case.kinetics || chosen.empty()) return table;
  const cases::Kinetics& kinetics = *outcome.mill_case.kinetics;
  const bool second = powder::has_second_product(*kinetics.model);
  const bool warm = powder::reads_temperature(*kinetics.model);
  if (!kinetics.property.empty()) table.columns.push_back({"property", "1", kinetics.property});
  if (second)
    table.columns.insert(table.columns.end(), {{"yield", "1", "share of the first product"},
                                               {"second_yield", "1", "that of the second"}});
  if (warm) table.columns.push_back({"temperature", "K", "temperature of the powder"});
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double time = kinetics.time * i / points;
    const auto mean = [&](double powder::ReactionShares::*which) {
      return mean_over(chosen, [&](const Replicate& r) {
        return powder::reaction_shares(*kinetics.model, r.grinding->conditions, time).*which;
      });
    };
    const double dose =
        mean_over(chosen, [&](const Replicate& r) { return r.grinding->dose_rate * time; });
    const double done = mean(&powder::ReactionShares::conversion);
    std::vector<double> row{time, dose / 1000, done};
    if (!kinetics.property.empty())
      row.push_back(std::lerp(kinetics.initial, kinetics.final, done));
    if (second)
      row.insert(row.end(), {mean(&powder::ReactionShares::product),
                             mean(&powder::ReactionShares::second_product)});
    if (warm)
      row.push_back(mean_over(
          chosen, [&](const Replicate& r) { return r.grinding->conditions.temperature.at(time); }));
    table.rows.push_back(std::move(row));
  }
  return table;
}

namespace {

void few_hits(const Case& mill_case, const Chosen& chosen, Notices& list) {
  const auto& model = std::get<ImpactKinetics>(*mill_case.kinetics->model);
  constexpr double few = 100;
  double count = 0, largest = 0;
  for (const Replicate* r : chosen) {
    for (const powder::PowderHits& hit : r->grinding->conditions.hits)
      largest = std::max(largest, hit.energy);
    count += model.rates(r->grinding->conditions).hits * r->time();
  }
  if (count == 0)
    list.push_back(warning(
        "no-hit-above-threshold",
        fmt::format("No hit reaches the threshold energy of [kinetics], {}: nothing reacts. The "
                    "most energetic hits have {}.",
                    show_rounded(model.threshold_energy, "J"), show_rounded(largest, "J"))));
  else if (count < few)
    list.push_back(warning(
        "few-hits-above-threshold",
        fmt::format("Only {:.0f} hits of the run reach the threshold energy of [kinetics], {}: the "
                    "conversion is as uncertain as their number. A longer run counts more.",
                    count, show_rounded(model.threshold_energy, "J"))));
}

void no_ignition(const Case& mill_case, const Chosen& chosen, Notices& list) {
  const double time = mill_case.kinetics->time;
  std::size_t cold = 0;
  double soonest = INFINITY;
  for (const Replicate* r : chosen) {
    const double at = ignition_time(mill_case, r->grinding->conditions);
    soonest = std::min(soonest, at);
    cold += at > time ? 1 : 0;
  }
  if (cold == 0) return;
  list.push_back(note(
      "no-ignition",
      fmt::format(
          "The powder does not ignite within {} of milling{}: {}.", show_rounded(time, "s"),
          cold < chosen.size() ? fmt::format(" in {} of {} replicates", cold, chosen.size()) : "",
          std::isfinite(soonest) ? "it would after " + show_rounded(soonest, "s")
                                 : "nor in ten times as long")));
}

}  // namespace

Notices kinetics_warnings(const Outcome& outcome) {
  const Chosen chosen = grinding_replicates(outcome);
  Notices list;
  if (chosen.empty() || !outcome.mill_case.kinetics) return list;
  const powder::AnyKinetics& model = *outcome.mill_case.kinetics->model;
  if (powder::reads_hits(model)) few_hits(outcome.mill_case, chosen, list);
  if (std::holds_alternative<powder::IgnitionKinetics>(model))
    no_ignition(outcome.mill_case, chosen, list);
  return list;
}

}  // namespace mahlwerk::results
