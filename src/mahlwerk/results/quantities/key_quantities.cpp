// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/key_quantities.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "mahlwerk/results/quantities/measure.hpp"

namespace mahlwerk::results {
std::optional<std::pair<double, double>> Sensitivity::range(std::string_view quantity,
                                                            double value) const {
  const auto found = std::ranges::find(quantities, quantity);
  if (found == quantities.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(found - quantities.begin());
  double low = value, high = value;
  for (const AssumedInfluence& one : keys)
    for (const std::vector<double>& values : one.at_ends) {
      if (!beyond_chance(i, values[i], value)) continue;
      low = std::fmin(low, values[i]);
      high = std::fmax(high, values[i]);
    }
  return std::pair{low, high};
}

namespace {

/// Names of the records that have a place, in that order.
std::vector<std::string> in_places(int QuantityTraits::*place) {
  std::map<int, std::string> sorted;
  for (const Measure& m : all_measures())
    if (m.traits.*place > 0) sorted[m.traits.*place] = m.name;
  std::vector<std::string> names;
  for (const auto& [number, name] : sorted) names.push_back(name);
  return names;
}

/// The heading of the group of a quantity, whether or not the first of the group is there.
std::string_view heading_of(std::string_view quantity) {
  static const auto all = [] {
    std::map<std::string_view, std::string_view> headings;
    std::string_view last = "Results";
    for (const Measure& m : all_measures()) {
      if (!m.traits.heading.empty()) last = m.traits.heading;
      headings.emplace(m.name, last);
    }
    return headings;
  }();
  const auto found = all.find(quantity);
  return found == all.end() ? std::string_view() : found->second;
}

}  // namespace

std::vector<std::string> key_quantities(const std::vector<Quantity>& list) {
  static const std::vector<std::string> all = in_places(&QuantityTraits::key);
  std::vector<std::string> found;
  for (const std::string& name : all)
    if (std::ranges::find(list, name, &Quantity::name) != list.end()) found.push_back(name);
  return found;
}

const std::vector<std::string>& usual_columns() {
  static const std::vector<std::string> all = in_places(&QuantityTraits::column);
  return all;
}

std::vector<QuantityGroup> quantity_groups(const std::vector<Quantity>& list) {
  std::vector<QuantityGroup> all;
  for (const Quantity& q : list) {
    const std::string_view heading = heading_of(q.name);
    if (all.empty() || (!heading.empty() && heading != all.back().heading))
      all.push_back({heading.empty() ? std::string_view("Results") : heading, {}});
    all.back().names.push_back(q.name);
  }
  return all;
}

}  // namespace mahlwerk::results
