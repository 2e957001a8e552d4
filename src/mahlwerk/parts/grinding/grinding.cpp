// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Capture, breakage and sizes of the powder: the sections [capture], [breakage], [fragments] and
// [grinding], which the run itself reads for the stream of hits (docs/theory/powder.md).
#include "mahlwerk/results/quantities/grinding.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/parts/grinding/faults.hpp"
#include "mahlwerk/parts/grinding/plots.hpp"
#include "mahlwerk/parts/grinding/section.hpp"
#include "mahlwerk/parts/grinding/warnings.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/files/result_tables.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::parts::grinding {
namespace {

using cases::Case;
using report::figure;
using report::Multiple;
using report::multiple;
using report::text_of;
using results::Outcome;
using results::Quantity;
using Quantities = std::vector<Quantity>;

/// Compares the powder's power with the dissipated power. Powder does not act on the balls, so it
/// can receive more energy than the balls lose.
std::string beside_the_losses(const cases::Case& mill_case, const Quantities& list) {
  const double gets = 1000 * mill_case.powder->mass * named(list, "captured_dose_rate").value,
               lost = named(list, "dissipated_power").value;
  if (!(gets > 0) || !(lost > 0)) return "";
  return fmt::format(" That is {} the dissipated power{}", report::share_of(gets / lost),
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
             text_of(list, "captured_mass_rate"), named(list, "captured_share_rate").value,
             text_of(list, "captured_energy_mean"), text_of(list, "captured_dose_rate"),
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
             show_rounded(g.time, "s"), text_of(list, "d10"), text_of(list, "d50"),
             text_of(list, "d90"), text_of(list, "specific_surface")) +
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

std::string panel(const Outcome& outcome) {
  if (results::grinding_replicates(outcome).empty()) return "";
  const Quantities& list = outcome.summary.quantities;
  return (outcome.mill_case.capture ? capture_section(outcome, list) : "") +
         (outcome.mill_case.grinding ? fineness_section(outcome, list) : "");
}

bool grinds(const Case& c) {
  return c.grinding.has_value();
}
/// [breakage] and [fragments] also serve grains that break in the bed.
bool has_models(const Case& c) {
  return grinds(c) || c.bed_breakage;
}

results::Measures quantities() {
  results::Measures all = results::capture_measures();
  std::ranges::move(results::grinding_measures(), std::back_inserter(all));
  return all;
}

std::vector<results::NamedTable> tables(const Outcome& outcome) {
  return {
      {"capture", "captured powder per bin of energy, by kind of pair", results::capture(outcome)},
      {"captured_grains", "collisions by number of captured grains",
       results::captured_grains(outcome)},
      {"grinding", "sizes of the powder over the milling time", results::grinding(outcome)},
      {"size_distribution", "sizes of the powder at some times",
       results::size_distribution(outcome)}};
}

}  // namespace

const cases::Part& part() {
  using cases::KeyVisitor;
  static const cases::Part made{
      .name = "grinding",
      .sections = {{{"capture", "model", "how much powder a collision captures"},
                    [](const Case& c) { return c.capture.has_value(); },
                    [](Case& c) { c.capture.emplace(); },
                    [](KeyVisitor& v, Case& c) { describe(v, *c.capture, c); }},
                   {{"breakage", "model",
                     "which hits break a grain; the powder's material may give the constants"},
                    has_models,
                    nullptr,
                    [](KeyVisitor& v, Case& c) {
                      describe(v, c.grinding ? *c.grinding->breakage : *c.bed_breakage->breakage,
                               c);
                    }},
                   {{"fragments", "model", "the fragments of a broken grain"},
                    has_models,
                    nullptr,
                    [](KeyVisitor& v, Case& c) {
                      describe(v, c.grinding ? *c.grinding->fragments : *c.bed_breakage->fragments,
                               c);
                    }},
                   {{"grinding", "", "how the size of the powder changes with time"},
                    grinds,
                    [](Case& c) { c.grinding.emplace(); },
                    [](KeyVisitor& v, Case& c) { describe(v, *c.grinding, c); }}},
      .read = read,
      .check = check,
      .quantities = quantities,
      .tables = tables,
      .notices = warnings,
      .panel = panel};
  return made;
}

}  // namespace mahlwerk::parts::grinding
