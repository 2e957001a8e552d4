// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/quantities/range.hpp"

#include <algorithm>
#include <array>

namespace mahlwerk::results {
namespace {

constexpr std::array<std::string_view, 14> shares{
    "contact_time_share",
    "tc_collision_share",
    "power_share_within_contact_time",
    "hit_share_within_contact_time",
    "flight_share",
    "airborne_share",
    "emptiest_sector",  // at most the mean mass of all sectors
    "occupied_share",
    "grazing_share",
    "finest_share",
    "conversion",
    "yield",
    "second_yield",
    "processed_share_per_hit"};

constexpr std::array<std::string_view, 87> not_negative{"collision_rate",
                                                        "ball_count",
                                                        "balls_mass",
                                                        "collision_rate_in_flight",
                                                        "collision_rate_between_balls",
                                                        "collision_rate_with_jar",
                                                        "energy_normal_mean",
                                                        "energy_contact_point_mean",
                                                        "energy_centre_mean",
                                                        "energy_tangential_mean",
                                                        "energy_lost_mean",
                                                        "impact_speed_normal_mean",
                                                        "impact_speed_tangential_mean",
                                                        "dissipated_power",
                                                        "drawn_power",
                                                        "drawn_power_of_mill",
                                                        "shaft_torque",
                                                        "rotor_torque",
                                                        "power_number",
                                                        "motor_power",
                                                        "jar_lag",
                                                        "intermittency",
                                                        "dissipated_power_normal",
                                                        "dissipated_power_tangential",
                                                        "dissipated_power_sliding",
                                                        "dissipated_power_rolling",
                                                        "dissipated_power_liquid",
                                                        "dissipated_power_of_collisions",
                                                        "collision_power_normal",
                                                        "collision_power_tangential",
                                                        "lasting_contacts_rate",
                                                        "withheld_power_share",
                                                        "impacts_per_ball",
                                                        "specific_energy_dose_rate",
                                                        "specific_energy_dose",
                                                        "specific_energy_dose_per_hour",
                                                        "time_to_dose",
                                                        "milling_time",
                                                        "specific_impact_power",
                                                        "stress_energy",
                                                        "stress_number_rate",
                                                        "wall_slip_ratio",
                                                        "froude_number",
                                                        "pinning_ratio",
                                                        "ball_speed_seen_from_carrier",
                                                        "ball_speed_seen_from_jar",
                                                        "ball_spin",
                                                        "tangential_impact_power",
                                                        "wear_rate_balls",
                                                        "wear_rate_jar",
                                                        "contamination_rate",
                                                        "flash_rise_mean",
                                                        "captured_mass_rate",
                                                        "captured_share_rate",
                                                        "captured_grains_mean",
                                                        "captured_energy_mean",
                                                        "captured_dose_rate",
                                                        "d10",
                                                        "d50",
                                                        "d90",
                                                        "specific_surface",
                                                        "specific_grinding_energy",
                                                        "milling_dose",
                                                        "milling_dose_per_mole",
                                                        "processing_hit_rate",
                                                        "processing_hit_energy",
                                                        "processed_mass_per_hit",
                                                        "processing_rate",
                                                        "ignition_time",
                                                        "grain_count",
                                                        "coarse_graining_ratio",
                                                        "particles_per_grain",
                                                        "energy_residual",
                                                        "energy_balance",
                                                        "deepest_overlap",
                                                        "simulated_time",
                                                        "charge_distance",
                                                        "drum_speed",
                                                        "bulk_filling",
                                                        "void_filling",
                                                        "impact_efficiency",
                                                        "motor_power_scatter",
                                                        "heard_hit_rate",
                                                        "heard_hit_energy_mean",
                                                        "acceleration_rms",
                                                        "acceleration_rms_of_impacts",
                                                        "acceleration_peak"};

template <class Names>
bool holds(const Names& names, std::string_view name) {
  return std::ranges::find(names, name) != names.end();
}

}  // namespace

Range range_of(std::string_view quantity) {
  constexpr std::string_view above = "_above_threshold";
  if (quantity.ends_with(above)) quantity.remove_suffix(above.size());
  if (quantity == "impact_angle_mean") return {0, 90};
  if (holds(shares, quantity)) return {0, 1};
  if (holds(not_negative, quantity)) return {.least = 0};
  return {};
}

}  // namespace mahlwerk::results
