// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Conversion of the powder: the section [kinetics] (docs/theory/kinetics.md).
#include "mahlwerk/results/quantities/kinetics.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/sections/sections.hpp"
#include "mahlwerk/parts/kinetics/plots.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::parts::kinetics {
namespace {

using cases::Case;
using report::figure;
using report::readable;
using results::Outcome;
using results::Quantity;
using Quantities = std::vector<Quantity>;

std::string shown_text(const Quantities& list, std::string_view name) {
  const auto found = std::ranges::find(list, name, &Quantity::name);
  return found == list.end() ? "-" : readable(*found).text();
}

/// What the conversion follows, as a sentence.
std::string kinetics_basis(const Outcome& outcome, const Quantities& list) {
  const cases::Kinetics& k = *outcome.mill_case.kinetics;
  if (powder::name_of(*k.model) != "dose")
    return fmt::format("By the model {}; the constants are those of the case.",
                       powder::name_of(*k.model));
  return fmt::format(
      "By the energy {} per mass of powder, {} after {}; the constants are those of the case.",
      k.dose == cases::Kinetics::Dose::captured ? "that captured grains receive" : "dissipated",
      shown_text(list, "milling_dose"), show_rounded(k.time, "s"));
}

/// What the hits do, for kinetics by impact; the time of ignition.
std::string kinetics_numbers(const Outcome& outcome, const Quantities& list) {
  const powder::AnyKinetics& model = *outcome.mill_case.kinetics->model;
  if (powder::reads_hits(model))
    return fmt::format(
        "<p>{} hits per second process powder, with {} each; a hit processes {} on the mean. Each "
        "part of the reactant is processed {} times per second.</p>\n",
        shown_text(list, "processing_hit_rate"), shown_text(list, "processing_hit_energy"),
        shown_text(list, "processed_mass_per_hit"), shown_text(list, "processing_rate"));
  if (powder::name_of(model) == "ignition")
    return fmt::format("<p>Time of milling until the powder ignites: {}.</p>\n",
                       shown_text(list, "ignition_time"));
  return "";
}

std::string kinetics_section(const Outcome& outcome, const Quantities& list) {
  const cases::Kinetics& k = *outcome.mill_case.kinetics;
  const bool by_dose = powder::name_of(*k.model) == "dose";
  return fmt::format("<h2>{}</h2>\n<p>After {} of milling the conversion is {}.</p>\n",
                     by_dose ? "Dose" : "Kinetics", show_rounded(k.time, "s"),
                     shown_text(list, "conversion")) +
         kinetics_numbers(outcome, list) +
         figure(conversion_plot(outcome),
                kinetics_basis(outcome, list) + " conversion.csv has the numbers.") +
         (k.property.empty() ? "" : figure(property_plot(outcome), "Follows the conversion."));
}

std::string panel(const Outcome& outcome) {
  if (!outcome.mill_case.kinetics || results::grinding_replicates(outcome).empty()) return "";
  return kinetics_section(outcome, outcome.summary.quantities);
}

void describe(cases::KeyVisitor& v, cases::Kinetics& values, const Case& c) {
  cases::describe(v, values, c);
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
      .quantities = results::kinetics_measures,
      .tables = tables,
      .notices = results::kinetics_warnings,
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::kinetics
