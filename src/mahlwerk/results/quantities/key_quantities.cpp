// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/key_quantities.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mahlwerk::results {
namespace {

constexpr std::array<std::string_view, 13> first_asked{"dissipated_power",
                                                       "collision_rate_above_threshold",
                                                       "energy_normal_mean_above_threshold",
                                                       "specific_energy_dose_rate",
                                                       "specific_energy_dose_per_hour",
                                                       "specific_energy_dose",
                                                       "time_to_dose",
                                                       "temperature_balls",
                                                       "d50",
                                                       "conversion",
                                                       "contamination_rate",
                                                       "motor_power",
                                                       "heard_hit_rate"};

/// The first quantity of each group, and the group's heading. Every result with the group has that
/// quantity.
using Group = std::pair<std::string_view, std::string_view>;
constexpr std::array groups{
    Group{"collision_rate", "Collisions"},
    Group{"dissipated_power", "Power and contacts"},
    Group{"specific_energy_dose_rate", "Energy per mass of powder"},
    Group{"flight_share", "Motion of the charge"},
    Group{"wear_rate_balls", "Wear"},
    Group{"temperature_balls", "Temperatures"},
    Group{"captured_mass_rate", "Powder captured by collisions"},
    Group{"d10", "Fineness"},
    Group{"milling_dose", "Dose"},
    Group{"motor_power", "Power meter"},
    Group{"heard_hit_rate", "Microphone"},
    Group{"acceleration_rms", "Accelerometer"},
    Group{"thermocouple_reading", "Thermocouple"},
    Group{"grain_count", "Powder as grains"},
    Group{"energy_residual", "Numerical accuracy"},
};

}  // namespace

std::optional<std::pair<double, double>> Sensitivity::range(std::string_view quantity,
                                                            double value) const {
  const auto found = std::ranges::find(quantities, quantity);
  if (found == quantities.end()) return std::nullopt;
  const auto i = static_cast<std::size_t>(found - quantities.begin());
  double low = value, high = value;
  for (const AssumedInfluence& one : keys)
    for (const std::vector<double>& values : one.at_ends) {
      if (!(std::abs(values[i] - value) > scatter[i])) continue;
      low = std::fmin(low, values[i]);
      high = std::fmax(high, values[i]);
    }
  return std::pair{low, high};
}

std::vector<std::string> key_quantities(const std::vector<Quantity>& list) {
  std::vector<std::string> found;
  for (const std::string_view name : first_asked)
    if (std::ranges::find(list, name, &Quantity::name) != list.end()) found.emplace_back(name);
  return found;
}

std::vector<QuantityGroup> quantity_groups(const std::vector<Quantity>& list) {
  std::vector<QuantityGroup> all;
  for (const Quantity& q : list) {
    const auto begins = std::ranges::find(groups, q.name, &Group::first);
    if (begins != groups.end() || all.empty())
      all.push_back({begins == groups.end() ? std::string_view("Results") : begins->second, {}});
    all.back().names.push_back(q.name);
  }
  return all;
}

}  // namespace mahlwerk::results
