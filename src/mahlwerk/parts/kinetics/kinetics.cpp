// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Conversion of the powder: the section [kinetics] (docs/theory/kinetics.md).
#include "mahlwerk/results/quantities/kinetics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/faults.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/parts/kinetics/plots.hpp"
#include "mahlwerk/parts/kinetics/section.hpp"
#include "mahlwerk/powder/models.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::parts::kinetics {
namespace {

using cases::Case;
using cases::Kinetics;
using report::figure;
using report::text_of;
using results::Outcome;
using results::Quantity;
using Quantities = std::vector<Quantity>;

/// What the conversion follows, as a sentence.
std::string kinetics_basis(const Outcome& outcome, const Quantities& list) {
  const Kinetics& k = *outcome.mill_case.kinetics;
  if (powder::name_of(*k.model) != "dose")
    return fmt::format("By the model {}; the constants are those of the case.",
                       powder::name_of(*k.model));
  return fmt::format(
      "By the energy {} per mass of powder, {} after {}; the constants are those of the case.",
      k.dose == cases::Kinetics::Dose::captured ? "that captured grains receive" : "dissipated",
      text_of(list, "milling_dose"), show_rounded(k.time, "s"));
}

/// What the hits do, for kinetics by impact; the time of ignition.
std::string kinetics_numbers(const Outcome& outcome, const Quantities& list) {
  const powder::AnyKinetics& model = *outcome.mill_case.kinetics->model;
  if (powder::reads_hits(model))
    return fmt::format(
        "<p>{} hits per second process powder, with {} each; a hit processes {} on the mean. Each "
        "part of the reactant is processed {} times per second.</p>\n",
        text_of(list, "processing_hit_rate"), text_of(list, "processing_hit_energy"),
        text_of(list, "processed_mass_per_hit"), text_of(list, "processing_rate"));
  if (powder::name_of(model) == "ignition")
    return fmt::format("<p>Time of milling until the powder ignites: {}.</p>\n",
                       text_of(list, "ignition_time"));
  return "";
}

std::string kinetics_section(const Outcome& outcome, const Quantities& list) {
  const Kinetics& k = *outcome.mill_case.kinetics;
  const bool by_dose = powder::name_of(*k.model) == "dose";
  return fmt::format("<h2>{}</h2>\n<p>After {} of milling the conversion is {}.</p>\n",
                     by_dose ? "Dose" : "Kinetics", show_rounded(k.time, "s"),
                     text_of(list, "conversion")) +
         kinetics_numbers(outcome, list) +
         figure(conversion_plot(outcome),
                kinetics_basis(outcome, list) + " conversion.csv has the numbers.") +
         (k.property.empty() ? "" : figure(property_plot(outcome), "Follows the conversion."));
}

void fault(const Case& c, std::vector<Fault>& found, const std::string& key, std::string what,
           std::string remedy, std::string code) {
  found.push_back(
      {cases::location_of(c, key), std::move(what), std::move(remedy), std::move(code)});
}

void by_impact(const Case& c, const Kinetics& k, const powder::ImpactKinetics& m,
               std::vector<Fault>& found) {
  if (!c.capture && !k.mass_per_hit)
    fault(c, found, "kinetics.model",
          "[kinetics] model = \"by-impact\" needs the mass of powder that a hit captures",
          "add [capture], or write mass_per_hit = \"1 mg\" or so", "missing-value");
  if (m.scheme == powder::ImpactKinetics::Scheme::parallel && m.energy_exponent == 0 &&
      m.processed_share + m.second_share > 1)
    fault(c, found, "kinetics.second_share",
          fmt::format("both reactions would process {:.4g} times the powder that a hit captures",
                      m.processed_share + m.second_share),
          "give shares with a sum of at most 1", "out-of-range");
}

void check(const Case& c, std::vector<Fault>& found) {
  const Kinetics& k = *c.kinetics;
  const bool by_dose = std::holds_alternative<powder::DoseKinetics>(*k.model);
  if (!c.powder)
    fault(c, found, by_dose ? "kinetics.dose_constant" : "kinetics.model",
          "[kinetics] needs a powder that takes the dose", "add [powder] with mass",
          "missing-value");
  if (k.dose == Kinetics::Dose::captured && !c.capture)
    fault(c, found, "kinetics.dose",
          "dose = \"captured\" needs [capture]: the powder that collisions capture",
          "add [capture], or write dose = \"dissipated\"", "lone-section");
  if (const auto* m = std::get_if<powder::ImpactKinetics>(&*k.model)) by_impact(c, k, *m, found);
  if (powder::reads_temperature(*k.model) && !k.temperature && !c.heat)
    fault(c, found, "kinetics.model",
          fmt::format("[kinetics] model = \"{}\" needs the temperature of the powder",
                      powder::name_of(*k.model)),
          "write temperature = \"60 degC\" or so, or add [heat]", "missing-value");
  if (const auto* m = std::get_if<powder::IgnitionKinetics>(&*k.model);
      m != nullptr && m->milled_temperature > m->ignition_temperature)
    fault(c, found, "kinetics.milled_temperature",
          fmt::format("milling would raise the ignition temperature, from {} to {}",
                      show_rounded(m->ignition_temperature, "K"),
                      show_rounded(m->milled_temperature, "K")),
          "give a milled_temperature of at most ignition_temperature", "out-of-range");
}

std::string panel(const Outcome& outcome) {
  if (results::grinding_replicates(outcome).empty()) return "";
  return kinetics_section(outcome, outcome.summary.quantities);
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {
      {"conversion", "dose and conversion over the milling time", results::conversion(outcome)}};
}

}  // namespace

const cases::Part& part() {
  static const cases::Part made{
      .name = "kinetics",
      .sections = {cases::section_in_case<&Case::kinetics, describe>(
          {"kinetics", "model", "conversion of the powder: a reaction or a property"})},
      .check = check,
      .quantities = results::kinetics_measures,
      .tables = tables,
      .notices = results::kinetics_warnings,
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::kinetics
