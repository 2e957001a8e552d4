// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The groups of quantities, in the order of summary.json.
#include <algorithm>
#include <iterator>
#include <map>

#include "mahlwerk/cases/part.hpp"
#include "mahlwerk/results/quantities/bed.hpp"
#include "mahlwerk/results/quantities/groups.hpp"
#include "mahlwerk/results/quantities/motion_states.hpp"
#include "mahlwerk/results/quantities/pairs.hpp"
#include "mahlwerk/results/quantities/part_loads.hpp"
#include "mahlwerk/results/quantities/regime.hpp"

namespace mahlwerk::results {
namespace {

constexpr std::string_view above_threshold = "_above_threshold";

Measures all_groups() {
  Measures all;
  const auto add = [&](Measures (*group)()) {
    std::ranges::move(group(), std::back_inserter(all));
  };
  for (Measures (*group)() :
       {collision_rates, collision_rates_by_partner, collision_means, power_measures, loss_measures,
        contact_time_measures, mill_measures, mill_power_measures, energy_balance_measures,
        dose_measures, regime_measures, motion_state_measures, motion_measures, bed_measures,
        part_measures, tangential_measures, body_measures})
    add(group);
  for (const cases::Part* part : cases::parts())
    if (part->quantities != nullptr) add(part->quantities);
  add(grain_measures);
  add(check_measures);
  return all;
}

using RecordsByName = std::map<std::string_view, const Measure*>;

RecordsByName all_records() {
  RecordsByName all;
  for (const Measures* list : {&all_measures(), &measures_of_whole()})
    for (const Measure& m : *list) all.emplace(m.name, &m);
  return all;
}

using TraitsByName = std::map<std::string_view, QuantityTraits>;

TraitsByName all_traits() {
  TraitsByName all;
  for (const auto& [name, record] : all_records()) all.emplace(name, record->traits);
  for (const PairMeasure& m : pair_measures()) all.emplace(m.name, m.traits);
  return all;
}

std::string_view over_all_collisions(std::string_view quantity) {
  if (quantity.ends_with(above_threshold)) quantity.remove_suffix(above_threshold.size());
  return quantity;
}

}  // namespace

Measures where(bool (*applies)(const cases::Case&), std::string_view only, Measures list) {
  for (Measure& m : list) {
    m.group_applies = applies;
    m.group_only = only;
  }
  return list;
}

const Measures& all_measures() {
  static const Measures all = all_groups();
  return all;
}

const Measure* record_of(std::string_view quantity) {
  static const RecordsByName all = all_records();
  const auto found = all.find(quantity);
  return found == all.end() ? nullptr : found->second;
}

Measures applying(const Measures& list, const cases::Case& mill_case) {
  Measures there;
  for (const Measure& m : list) {
    if (m.group_applies != nullptr && !m.group_applies(mill_case)) continue;
    if (m.traits.applies != nullptr && !m.traits.applies(mill_case)) continue;
    there.push_back(m);
    if (m.traits.about != nullptr) there.back().about = m.traits.about(mill_case);
  }
  return there;
}

const QuantityTraits& traits_of(std::string_view quantity) {
  static const TraitsByName all = all_traits();
  static const QuantityTraits none{.range = any_value};
  const auto found = all.find(over_all_collisions(quantity));
  return found == all.end() ? none : found->second;
}

std::string label_of(std::string_view quantity) {
  const std::string_view base = over_all_collisions(quantity);
  std::string text(traits_of(base).label.empty() ? base : traits_of(base).label);
  if (traits_of(base).label.empty()) std::ranges::replace(text, '_', ' ');
  return base == quantity ? text : text + " above threshold";
}

}  // namespace mahlwerk::results
