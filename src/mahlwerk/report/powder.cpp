// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/powder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/powder_plots.hpp"
#include "mahlwerk/report/readable.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::report {
namespace {

using results::Outcome;
using results::Quantity;
using Quantities = std::vector<Quantity>;

std::string shown_text(const Quantities& list, std::string_view name) {
  const auto found = std::ranges::find(list, name, &Quantity::name);
  return found == list.end() ? "-" : readable(*found).text();
}

double value(const Quantities& list, std::string_view name) {
  const auto found = std::ranges::find(list, name, &Quantity::name);
  return found == list.end() ? std::nan("") : found->value;
}

/// Compares the powder's power with the dissipated power. Powder does not act on the balls, so it
/// can receive more energy than the balls lose.
std::string beside_the_losses(const cases::Case& mill_case, const Quantities& list) {
  const double gets = 1000 * mill_case.powder->mass * value(list, "captured_dose_rate"),
               lost = value(list, "dissipated_power");
  if (!(gets > 0) || !(lost > 0)) return "";
  return fmt::format(" That is {} the dissipated power{}", share_of(gets / lost),
                     gets > lost ? ": more than the mill dissipates. Balls with powder between "
                                   "them bounce less than these do; account for that with "
                                   "restitution, energy_share or energy = &quot;lost&quot;."
                                 : ".");
}

std::string energy_words(const cases::Capture& capture) {
  using Energy = cases::Capture::Energy;
  const std::string which = capture.energy == Energy::normal          ? "of the normal motion"
                            : capture.energy == Energy::contact_point ? "at the contact point"
                                                                      : "that is lost";
  if (capture.energy_share == 1)
    return fmt::format(
        "The energy is that {}; the grains receive all of it (energy_share = 1), an upper bound.",
        which);
  return fmt::format(
      "The energy is that {}; the grains receive {:.4g} % of it, as the case sets (energy_share).",
      which, 100 * capture.energy_share);
}

std::string capture_section(const Outcome& outcome, const Quantities& list) {
  const cases::Case& mill_case = outcome.mill_case;
  const powder::AnyCapture& model = *mill_case.capture->model;
  const Multiple size = multiple(*mill_case.powder->size, "m");
  return fmt::format(
             "<h2>Powder captured by collisions</h2>\n<p>Collisions capture {} of powder: a grain "
             "is captured {:.3g} times per second and receives {} each time, {} in total.{}</p>\n",
             shown_text(list, "captured_mass_rate"), value(list, "captured_share_rate"),
             shown_text(list, "captured_energy_mean"), shown_text(list, "captured_dose_rate"),
             beside_the_losses(mill_case, list)) +
         figure(
             capture_plot(outcome),
             fmt::format("Grains of {}, the median of the feed, by the model {}: {}. {} "
                         "capture.csv has the numbers. Only the kinds of pairs with the most "
                         "power are shown.",
                         fmt::format("{:.3g} {}", *mill_case.powder->size / size.factor, size.unit),
                         powder::name_of(model), powder::about(model),
                         energy_words(*mill_case.capture))) +
         figure(captured_energy_plot(outcome),
                "That share of the energy per captured mass, for grains of equal size.") +
         figure(
             captured_grains_plot(outcome),
             "Share of the collisions, and of their energy, by the number of captured grains; four "
             "bins per octave, single grains left of 1. captured_grains.csv has the numbers.");
}

std::string fineness_section(const Outcome& outcome, const Quantities& list) {
  const cases::Grinding& g = *outcome.mill_case.grinding;
  using Method = cases::Grinding::Method;
  const std::string sample = fmt::format("a sample of {} grains", g.sample);
  const std::string how = g.method == Method::statistical ? "By " + sample + "."
                          : g.method == Method::balance
                              ? "By the population balance."
                              : "Solid: the population balance; dashed: " + sample + ".";
  return fmt::format(
             "<h2>Fineness</h2>\n<p>After {} of milling D10, D50 and D90 are {}, {} and "
             "{}; "
             "the specific surface is {}.</p>\n",
             show_rounded(g.time, "s"), shown_text(list, "d10"), shown_text(list, "d50"),
             shown_text(list, "d90"), shown_text(list, "specific_surface")) +
         figure(
             sizes_plot(outcome),
             fmt::format(
                 "{} Breakage by {}, fragments by {}, with the parameters of the case. The sizes "
                 "are as certain as these parameters and the share of the energy that the grains "
                 "receive. Their change with time and with the mill's settings is more certain.",
                 how, powder::name_of(*g.breakage), powder::name_of(*g.fragments))) +
         figure(passing_plot(outcome), "By mass. size_distribution.csv has the numbers.") +
         figure(density_plot(outcome),
                "The area below a curve between two sizes is the mass share between them. A narrow "
                "feed may exceed the plot; mass that reaches the finest class stays there.") +
         figure(surface_plot(outcome),
                "Surface of spheres of these sizes. grinding.csv has the numbers.");
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

}  // namespace

std::string powder_sections(const Outcome& outcome) {
  const std::vector<const results::Replicate*> chosen = results::averaged_replicates(outcome);
  if (std::ranges::none_of(chosen, [](const auto* r) { return r->grinding.has_value(); }))
    return "";
  const Quantities& list = outcome.summary.quantities;
  std::string text;
  if (outcome.mill_case.capture) text += capture_section(outcome, list);
  if (outcome.mill_case.grinding) text += fineness_section(outcome, list);
  if (outcome.mill_case.kinetics) text += kinetics_section(outcome, list);
  return text;
}

}  // namespace mahlwerk::report
