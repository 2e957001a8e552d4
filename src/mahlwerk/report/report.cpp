// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/report/key_numbers.hpp"
#include "mahlwerk/report/maps.hpp"
#include "mahlwerk/report/methods.hpp"
#include "mahlwerk/report/page.hpp"
#include "mahlwerk/report/plots.hpp"
#include "mahlwerk/report/replay.hpp"
#include "mahlwerk/report/states.hpp"
#include "mahlwerk/report/table.hpp"
#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/summary.hpp"

namespace mahlwerk::report {
namespace {

using results::named;
using results::Outcome;
using results::Quantity;

/// A table cell with the quantity's name and exact value as data attributes for programs.
std::string number_cell(const Quantity* q, const std::string& text) {
  if (q == nullptr || !std::isfinite(q->value))
    return fmt::format("<td class=\"n\">{}</td>", escaped(text));
  return fmt::format("<td class=\"n\" data-quantity=\"{}\" data-value=\"{}\">{}</td>", q->name,
                     shortest(q->value), escaped(text));
}

/// A group of quantities, with its heading.
struct RowGroup {
  std::string_view heading;
  std::string lines;
};

std::vector<RowGroup> row_groups(const std::vector<Quantity>& list) {
  std::vector<RowGroup> all;
  for (const Row& row : rows(list)) {
    if (!row.group.empty() || all.empty()) all.push_back({row.group, {}});
    const std::string title = label(*row.all);
    all.back().lines +=
        fmt::format("<tr><th scope=\"row\">{}<small>{}</small></th>{}{}</tr>\n", escaped(title),
                    with_symbols(row.all->about),
                    number_cell(row.only_above ? nullptr : row.all, row.all_text()),
                    number_cell(row.only_above ? row.all : row.above, row.above_text()));
  }
  return all;
}

/// The key numbers, then all quantities in groups that can be folded; the first two are open.
std::string results_section(const Outcome& outcome) {
  constexpr int open = 2;
  std::string groups;
  int count = 0;
  for (const RowGroup& group : row_groups(outcome.summary.quantities))
    groups += fmt::format(
        "<details{}><summary>{}</summary>\n<div class=\"wide\"><table class=\"quantities\">\n"
        "<thead><tr><th></th><th class=\"n\">all collisions</th><th class=\"n\">u<sub>n</sub> ≥ "
        "{}</th></tr></thead>\n<tbody>\n{}</tbody>\n</table></div></details>\n",
        count++ < open ? " open" : "", group.heading,
        threshold_text(outcome.mill_case.observe.threshold), group.lines);
  return "<h2>Results</h2>\n" + key_section(outcome) + "<h2>All quantities</h2>\n" + groups +
         "<p><small>± is the 95 % confidence half-width over independent replicates "
         "(Student's t), or of one alone over time (batch means). u<sub>n</sub> is the normal "
         "speed at first touch.</small></p>\n";
}

/// Table of collisions by kind of pair; empty if there is one kind.
std::string pairs_table(const Outcome& outcome) {
  const auto lines = pair_rows(outcome.summary.pairs);
  if (lines.empty()) return "";
  std::string head, body;
  for (const std::string& cell : pair_heading(outcome.mill_case.observe.threshold))
    head += fmt::format("<th class=\"n\">{}</th>", with_symbols(cell));
  for (const auto& line : lines) {
    body += fmt::format("<tr><th scope=\"row\">{}</th>", escaped(line.front()));
    for (std::size_t i = 1; i < line.size(); ++i)
      body += fmt::format("<td class=\"n\">{}</td>", escaped(line[i]));
    body += "</tr>\n";
  }
  return fmt::format(
      "<h2>Collisions by pair</h2>\n<div "
      "class=\"wide\"><table>\n<thead><tr>{}</tr></thead>\n<tbody>\n"
      "{}</tbody>\n</table></div>\n<p><small>The spectrum of each kind of pair is in "
      "spectra_by_pair.csv.</small></p>\n",
      head, body);
}

std::string origin_box(const Outcome& outcome, bool cases::Origin::*chosen,
                       std::string_view heading, std::string_view words) {
  std::string lines;
  for (const cases::Origin& o : outcome.mill_case.origins) {
    if (o.*chosen)
      lines += fmt::format("<tr><td><code>{}</code></td><td>{}</td><td>{}</td></tr>\n",
                           escaped(o.key), escaped(o.value),
                           escaped(o.range[0].empty() ? o.source
                                                      : fmt::format("{} to {}; {}", o.range[0],
                                                                    o.range[1], o.source)));
  }
  if (lines.empty()) return "";
  return fmt::format(
      "<section class=\"box\"><h2>{}</h2>\n<p>{}</p>\n<div "
      "class=\"wide\"><table><tbody>\n{}</tbody>"
      "</table></div></section>\n",
      heading, words, lines);
}

std::string methods_box(const Outcome& outcome, std::string_view version) {
  return fmt::format(
      "<h2>Methods paragraph</h2>\n<section class=\"box\"><p id=\"methods\">{}</p></section>\n",
      with_symbols(escaped(methods(outcome, version))));
}

std::string spectra_section(const Outcome& outcome) {
  return "<h2>Impact energies</h2>\n" +
         figure(
             spectrum_plot(outcome),
             "Collisions per second in each bin of energy (four bins per octave). The weakest "
             "bounces are not drawn; spectrum.csv has all of them, spectra_by_pair.csv by pair.") +
         figure(energy_weighted_plot(outcome),
                "The same weighted by energy: shows which impacts carry the power.") +
         figure(joint_energy_map(outcome),
                "Collisions per second by normal and tangential energy, one bin per octave; the "
                "colours cover four decades.") +
         figure(angle_plot(outcome),
                "Angle between the relative velocity and the normal at first contact.");
}

std::string maps_section(const Outcome& outcome) {
  std::string text =
      figure(wall_power_map(outcome),
             "Power lost by impacts on the jar per area of the wall, in axes fixed to the jar. "
             "wall_map.csv has the numbers. Losses of sustained contacts are not included.");
  for (const ColourMap& map : part_power_maps(outcome))
    text += figure(map,
                   "Power lost by impacts on the part per area of its surface, each view by the "
                   "direction of the part's own axes that it faces. part_map.csv has the numbers "
                   "of all parts.");
  text += figure(charge_map(outcome),
                 "Mean over the counted time in the plane of motion: mass per area as colour, "
                 "mean velocity as arrows. fields.csv has the numbers.");
  if (text.empty()) return "";
  std::string words;
  if (const std::string& regime = outcome.summary.regime; !regime.empty())
    words = fmt::format("<p>The charge is <strong>{}</strong>: {}.</p>\n", regime,
                        escaped(outcome.summary.regime_reason));
  return "<h2>Wall impacts and charge motion</h2>\n" + words + text;
}

std::string time_section(const Outcome& outcome) {
  return "<h2>Time series</h2>\n" +
         figure(rate_plot(outcome),
                "Each point is a mean over a time interval and the replicates.") +
         figure(power_plot(outcome),
                "Power input by the jar, and power dissipated in collisions and sustained "
                "contacts. In the long run both are equal.");
}

/// The panels of the parts. Parts with the same heading that follow each other stand below one.
std::string parts_section(const Outcome& outcome) {
  std::string text;
  std::string_view heading;
  for (const cases::Part* part : cases::parts_of(outcome.mill_case)) {
    const std::string panel = part->panel != nullptr ? part->panel(outcome) : "";
    if (panel.empty()) continue;
    if (!part->heading.empty() && part->heading != heading)
      text += fmt::format("<h2>{}</h2>\n", part->heading);
    heading = part->heading;
    text += panel;
  }
  return text;
}

std::string warning_box(const Outcome& outcome) {
  std::string lines;
  for (const Notice& one : outcome.notices)
    if (one.warns()) lines += fmt::format("<p>{}</p>\n", escaped(one.text));
  return lines.empty() ? "" : "<section class=\"box warn\">" + lines + "</section>\n";
}

}  // namespace

std::string sentence(const Outcome& outcome) {
  const std::vector<Quantity>& list = outcome.summary.quantities;
  const double count = named(list, "replicates").value;
  if (count == 0) return "No time was counted.";
  const Quantity& rate = named(list, "collision_rate_above_threshold");
  std::string text = fmt::format("In {} of {:.4g} s there were {} collisions per second",
                                 count == 1 ? "one run" : fmt::format("{:.0f} runs", count),
                                 named(list, "simulated_time").value, readable(rate).number);
  text += fmt::format(" with a normal speed of at least {}",
                      threshold_text(outcome.mill_case.observe.threshold));
  if (std::isfinite(named(list, "energy_normal_mean_above_threshold").value))
    text += fmt::format(", with a mean normal energy of {} and a mean contact-point energy of {}",
                        text_of(list, "energy_normal_mean_above_threshold"),
                        text_of(list, "energy_contact_point_mean_above_threshold"));
  return text + fmt::format("; the dissipated power was {}.", text_of(list, "dissipated_power"));
}

std::string report_page(const Outcome& outcome, std::string_view version, bool film) {
  const std::string& given = outcome.mill_case.title;
  std::string body = fmt::format("<p class=\"lead\">{}</p>\n", escaped(sentence(outcome)));
  body += warning_box(outcome);
  for (const Notice& one : outcome.notices)
    if (!one.warns())
      body += fmt::format("<section class=\"box\"><p>{}</p></section>\n", escaped(one.text));
  if (const std::string replay = film ? replay_section(outcome) : ""; !replay.empty())
    body += "<h2>Replay</h2>\n" + replay;
  body += results_section(outcome);
  body += states_section(outcome);
  body += pairs_table(outcome);
  if (!results::averaged_replicates(outcome).empty())
    body += spectra_section(outcome) + maps_section(outcome) + time_section(outcome) +
            parts_section(outcome);
  body += methods_box(outcome, version);
  body += "<h2>Assumptions and sources</h2>\n";
  body += origin_box(outcome, &cases::Origin::assumed, "Assumed, not measured",
                     "Values that the case does not give. If one of them matters to you, measure "
                     "it and add it to the case.");
  body += origin_box(outcome, &cases::Origin::unverified, "Unverified sources",
                     "Values whose source could not be verified.");
  body += fmt::format(
      "<details><summary>The case, with the origin of every value</summary>\n<pre>{}</pre>"
      "</details>\n",
      escaped(cases::write(outcome.mill_case)));
  const std::string footer = fmt::format(
      "Mahlwerk {}, {} engine, seed {}, {:.3g} s of CPU time. The numbers are in summary.json, "
      "result.h5 and the CSV files beside this page.",
      escaped(version), name_of(outcome.engine), outcome.mill_case.seed, outcome.cpu_seconds);
  return page(given.empty() ? "A ball mill" : given, body, footer);
}

}  // namespace mahlwerk::report
