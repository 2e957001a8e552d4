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

/// Balls feel no powder, so that it may be given more than they lose.
std::string beside_the_losses(const cases::Case& what, const Quantities& list) {
  const double gets = 1000 * what.powder->mass * value(list, "captured_dose_rate"),
               lost = value(list, "dissipated_power");
  if (!(gets > 0) || !(lost > 0)) return "";
  return fmt::format(" That is {} the dissipated power{}", share_of(gets / lost),
                     gets > lost ? ": more than the mill gives off. Balls with powder between them "
                                   "bounce less than these do; restitution, energy_share or energy "
                                   "= &quot;lost&quot; say so."
                                 : ".");
}

std::string energy_words(const cases::Capture& capture) {
  using Energy = cases::Capture::Energy;
  const std::string which = capture.energy == Energy::normal          ? "of the normal motion"
                            : capture.energy == Energy::contact_point ? "of the points of contact"
                                                                      : "that is lost";
  if (capture.energy_share == 1)
    return fmt::format(
        "The energy is that {}; all of it gets to the grains (energy_share = 1), an "
        "upper bound.",
        which);
  return fmt::format(
      "The energy is that {}; {:.4g} % of it gets to the grains, as the case says "
      "(energy_share).",
      which, 100 * capture.energy_share);
}

std::string capture_section(const Outcome& outcome, const Quantities& list) {
  const cases::Case& what = outcome.what;
  const powder::AnyCapture& model = *what.capture->model;
  const Multiple size = multiple(*what.powder->size, "m");
  return fmt::format(
             "<h2>What collisions catch</h2>\n<p>Collisions catch {} of powder: a grain is caught "
             "{:.3g} times a second and gets {} each time, {} in all.{}</p>\n",
             shown_text(list, "captured_mass_rate"), value(list, "captured_share_rate"),
             shown_text(list, "captured_energy_mean"), shown_text(list, "captured_dose_rate"),
             beside_the_losses(what, list)) +
         figure(catch_plot(outcome),
                fmt::format("Of grains of {}, the median of the feed, by the model {}: {}. {} "
                            "capture.csv has the numbers; of many kinds of pairs those with most "
                            "power are shown.",
                            fmt::format("{:.3g} {}", *what.powder->size / size.factor, size.unit),
                            powder::name_of(model), powder::about(model),
                            energy_words(*what.capture))) +
         figure(caught_energy_plot(outcome),
                "That share of the energy over the mass caught, grains alike.") +
         figure(caught_grains_plot(outcome),
                "How many collisions catch so many grains, and how much of the energy they carry; "
                "four bins an octave, single grains left of 1. captured_grains.csv has the "
                "numbers.");
}

std::string fineness_section(const Outcome& outcome, const Quantities& list) {
  const cases::Grinding& g = *outcome.what.grinding;
  using Method = cases::Grinding::Method;
  const std::string sample = fmt::format("a sample of {} grains", g.sample);
  const std::string how = g.method == Method::statistical ? "By " + sample + "."
                          : g.method == Method::balance
                              ? "By the population balance."
                              : "Solid: the population balance; dashed: " + sample + ".";
  return fmt::format(
             "<h2>How fine it gets</h2>\n<p>After {} of milling D10, D50 and D90 are {}, {} and "
             "{}; "
             "the specific surface is {}.</p>\n",
             show_rounded(g.time, "s"), shown_text(list, "d10"), shown_text(list, "d50"),
             shown_text(list, "d90"), shown_text(list, "specific_surface")) +
         figure(sizes_plot(outcome),
                fmt::format("{} Breakage by {}, fragments by {}, with the numbers of the case: the "
                            "sizes are as sure as those and the share of the energy that gets to "
                            "the grains. How they change with time and with the mill's settings is "
                            "surer.",
                            how, powder::name_of(*g.breakage), powder::name_of(*g.fragments))) +
         figure(passing_plot(outcome), "By mass. size_distribution.csv has the numbers.") +
         figure(density_plot(outcome),
                "The area below a curve between two sizes is the share between them. A narrow feed "
                "may be higher than the picture; what reaches the finest class stays there.") +
         figure(surface_plot(outcome), "Of spheres of these sizes; grinding.csv has the numbers.");
}

std::string dose_section(const Outcome& outcome, const Quantities& list) {
  const cases::Kinetics& k = *outcome.what.kinetics;
  const std::string basis = fmt::format(
      "By energy {} by mass of powder, {} after {}; the constants are the case's.",
      k.dose == cases::Kinetics::Dose::captured ? "that caught grains get" : "dissipated",
      shown_text(list, "milling_dose"), show_rounded(k.time, "s"));
  return fmt::format("<h2>Dose</h2>\n<p>After {} of milling the conversion is {}.</p>\n",
                     show_rounded(k.time, "s"), shown_text(list, "conversion")) +
         figure(conversion_plot(outcome), basis + " conversion.csv has the numbers.") +
         (k.property.empty() ? "" : figure(property_plot(outcome), "As conversion goes."));
}

}  // namespace

std::string powder_sections(const Outcome& outcome) {
  const std::vector<const results::Replicate*> chosen = results::averaged_replicates(outcome);
  if (std::ranges::none_of(chosen, [](const auto* r) { return r->grinding.has_value(); }))
    return "";
  const Quantities& list = outcome.summary.quantities;
  std::string text;
  if (outcome.what.capture) text += capture_section(outcome, list);
  if (outcome.what.grinding) text += fineness_section(outcome, list);
  if (outcome.what.kinetics) text += dose_section(outcome, list);
  return text;
}

}  // namespace mahlwerk::report
