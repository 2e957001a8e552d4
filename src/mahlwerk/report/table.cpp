// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mahlwerk/report/text/readable.hpp"
#include "mahlwerk/results/quantities/key_quantities.hpp"

namespace mahlwerk::report {
namespace {

constexpr std::string_view above_threshold = "_above_threshold";
using Line = std::array<std::string, 3>;

std::string padded(const std::string& text, std::size_t wanted) {
  return text + std::string(wanted - std::min(wanted, width(text)), ' ');
}

/// The largest value or half-width of a row, so that both numbers have the same multiple of the
/// unit.
double size_of(const Row& row) {
  const auto size = [](const results::Quantity& q) {
    return std::fmax(std::abs(q.value), q.half_width());
  };
  return row.above == nullptr ? size(*row.all) : std::fmax(size(*row.all), size(*row.above));
}

std::string without_blanks_behind(std::string text) {
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

}  // namespace

std::string Row::all_text() const {
  if (only_above) return "";
  return readable_within(all->value, all->half_width(), all->unit, results::range_of(all->name),
                         size_of(*this))
      .text();
}

std::string Row::above_text() const {
  const results::Quantity* q = only_above ? all : above;
  if (q == nullptr) return "";
  return readable_within(q->value, q->half_width(), q->unit, results::range_of(q->name),
                         size_of(*this))
      .text();
}

std::vector<Row> rows(const std::vector<results::Quantity>& quantities) {
  std::vector<Row> list;
  for (const results::QuantityGroup& group : results::quantity_groups(quantities)) {
    std::string_view heading = group.heading;
    for (const std::string& name : group.names) {
      const results::Quantity& q = results::named(quantities, name);
      const bool twin = q.name.ends_with(above_threshold) && !list.empty() &&
                        list.back().all->name + std::string(above_threshold) == q.name;
      if (twin)
        list.back().above = &q;
      else
        list.push_back(
            {&q, nullptr, std::exchange(heading, {}), results::traits_of(q.name).above_threshold});
    }
  }
  return list;
}

std::string table(const std::vector<results::Quantity>& quantities, double threshold) {
  std::vector<Line> lines{{"", "all collisions", "u_n >= " + threshold_text(threshold)}};
  for (const Row& row : rows(quantities)) {
    if (!row.group.empty()) {
      lines.push_back({});
      lines.push_back({std::string(row.group)});
    }
    lines.push_back({"  " + label(*row.all), row.all_text(), row.above_text()});
  }
  std::array<std::size_t, 3> widths{};
  for (const Line& line : lines)
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));
  std::string text;
  for (const Line& line : lines)
    text += without_blanks_behind(padded(line[0], widths[0] + 2) + padded(line[1], widths[1] + 2) +
                                  padded(line[2], widths[2])) +
            '\n';
  return text;
}

std::vector<std::string> pair_heading(double threshold) {
  return {"",
          "collisions",
          "u_n >= " + threshold_text(threshold),
          "mean normal energy",
          "of those above",
          "lost, normal",
          "lost, tangential"};
}

std::vector<std::vector<std::string>> pair_rows(const std::vector<results::PairSummary>& pairs) {
  constexpr std::array<std::string_view, 6> shown{
      "collision_rate",         "collision_rate_above_threshold",
      "energy_normal_mean",     "energy_normal_mean_above_threshold",
      "collision_power_normal", "collision_power_tangential"};
  std::vector<std::vector<std::string>> list;
  for (const results::PairSummary& pair : pairs) {
    const auto quantity = [&](std::string_view name) -> const results::Quantity& {
      return named(pair.quantities, name);
    };
    if (quantity("collision_rate").value == 0) continue;
    std::vector<std::string> row{pair.one + " with " + pair.other};
    for (const std::string_view name : shown) row.push_back(readable(quantity(name)).text());
    list.push_back(std::move(row));
  }
  return list;
}

std::string pair_table(const std::vector<results::PairSummary>& pairs, double threshold) {
  std::vector<std::vector<std::string>> lines = pair_rows(pairs);
  if (lines.empty()) return "";
  lines.insert(lines.begin(), pair_heading(threshold));
  std::vector<std::size_t> widths(lines.front().size(), 0);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], width(line[i]));
  std::string text;
  for (const auto& line : lines) {
    std::string one;
    for (std::size_t i = 0; i < line.size(); ++i) one += padded(line[i], widths[i] + 2);
    text += without_blanks_behind(std::move(one)) + '\n';
  }
  return text;
}

}  // namespace mahlwerk::report
