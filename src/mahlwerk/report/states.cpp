// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/states.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/report/aligned.hpp"
#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {
namespace {

using results::MotionStateSummary;
using results::Quantity;

constexpr std::array state_quantities{"dissipated_power", "collision_rate_above_threshold",
                                      "energy_normal_mean_above_threshold", "contact_time_share"};

/// A table of states, a column each.
struct StatesTable {
  std::vector<std::vector<std::string>> lines;  ///< heads first
  std::string title, below;                     ///< of the page's section
};

StatesTable by_power(const results::TwoStates& found) {
  StatesTable table{
      {{"two states"}},
      "Two states",
      fmt::format(
          "Replicates grouped by their dissipated power; ± is the 95 % confidence "
          "half-width over those of a state. A single normal distribution splits as clearly "
          "with a probability of {:.2g} %.",
          100 * found.p_value)};
  std::size_t all = 0;
  for (const results::State& state : found.states) all += state.replicates.size();
  for (const results::State& state : found.states)
    table.lines[0].push_back(fmt::format("{} of {} replicates ({:.0f} %)", state.replicates.size(),
                                         all, 100 * found.share(state)));
  for (const char* name : state_quantities) {
    table.lines.push_back({label(named(found.states[0].quantities, name))});
    for (const results::State& state : found.states)
      table.lines.back().push_back(readable(named(state.quantities, name)).text());
  }
  return table;
}

std::string text_of(const observe::Estimate& value, std::string_view name, std::string_view unit) {
  if (!std::isfinite(value.mean)) return "–";
  return readable(Quantity{.name = std::string(name),
                           .value = value.mean,
                           .ci95 = value.ci95,
                           .unit = std::string(unit),
                           .about = ""})
      .text();
}

StatesTable by_motion(const std::vector<MotionStateSummary>& found) {
  StatesTable table{
      {{"states of motion"},
       {"share of the time"},
       {"replicates with it"},
       {"time until it changes"},
       {"dissipated power"},
       {"hits"},
       {"mean normal energy of hits"},
       {"turns round the jar's axis in a period"},
       {"axial travel over the jar's"}},
      "States of motion",
      "Each period of the mill belongs to the state of more than half of the balls; a "
      "change counts once it has lasted three periods (obs.20). ± is the 95 % "
      "confidence half-width over the replicates."};
  for (const MotionStateSummary& s : found) {
    const std::array column{s.name,
                            text_of(s.share, "circling_share", "1"),
                            fmt::format("{}", s.replicates),
                            std::isfinite(s.visit) ? show_rounded(s.visit, "s") : "–",
                            text_of(s.power, "dissipated_power", "W"),
                            text_of(s.hit_rate, "collision_rate_above_threshold", "1/s"),
                            text_of(s.hit_energy, "energy_normal_mean_above_threshold", "J"),
                            text_of(s.turns, "turns_per_cycle", "1"),
                            text_of(s.axial_ratio, "axial_ratio", "1")};
    for (std::size_t i = 0; i < column.size(); ++i) table.lines[i].push_back(column[i]);
  }
  return table;
}

StatesTable by_part(const std::vector<results::PartSummary>& parts) {
  StatesTable table{{{"parts in the jar"}},
                    "Parts in the jar",
                    "What each part does to the balls: work per time, torque about its axis of "
                    "motion, force along the axes of its frame, hits above the threshold (obs.22). "
                    "± is the 95 % confidence half-width over the replicates."};
  for (const Quantity& q : parts.front().quantities) table.lines.push_back({label(q)});
  for (const results::PartSummary& part : parts) {
    table.lines[0].push_back(part.name);
    for (std::size_t i = 0; i < part.quantities.size(); ++i)
      table.lines[i + 1].push_back(readable(part.quantities[i]).text());
  }
  return table;
}

/// The parts in the jar; states by the balls' motion where this has several states, and by power.
std::vector<StatesTable> tables(const results::Outcome& outcome) {
  std::vector<StatesTable> all;
  if (!outcome.summary.parts.empty()) all.push_back(by_part(outcome.summary.parts));
  if (outcome.summary.motion_states.size() > 1)
    all.push_back(by_motion(outcome.summary.motion_states));
  if (outcome.summary.two_states) all.push_back(by_power(*outcome.summary.two_states));
  return all;
}

std::string section(const StatesTable& table) {
  std::string head, rows;
  for (std::size_t i = 1; i < table.lines[0].size(); ++i)
    head += fmt::format("<th class=\"n\">{}</th>", escaped(table.lines[0][i]));
  for (std::size_t k = 1; k < table.lines.size(); ++k) {
    rows += fmt::format("<tr><th scope=\"row\">{}</th>", escaped(table.lines[k][0]));
    for (std::size_t i = 1; i < table.lines[k].size(); ++i)
      rows += fmt::format("<td class=\"n\">{}</td>", escaped(table.lines[k][i]));
    rows += "</tr>\n";
  }
  return fmt::format(
      "<h2>{}</h2>\n<div class=\"wide\"><table>\n<thead><tr><th></th>{}</tr></thead>\n<tbody>\n{}"
      "</tbody>\n</table></div>\n<p><small>{}</small></p>\n",
      table.title, head, rows, table.below);
}

}  // namespace

std::string states_table(const results::Outcome& outcome) {
  std::string text;
  for (const StatesTable& table : tables(outcome)) text += aligned(table.lines) + '\n';
  return text;
}

std::string states_section(const results::Outcome& outcome) {
  std::string text;
  for (const StatesTable& table : tables(outcome)) text += section(table);
  return text;
}

}  // namespace mahlwerk::report
