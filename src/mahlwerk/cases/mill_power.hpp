// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "mahlwerk/base/notice.hpp"
#include "mahlwerk/cases/case.hpp"

// What the formulas of comminution give for the power of a tumbling mill
// (docs/theory/mill-power.md).
namespace mahlwerk::cases {

/// A tumbling mill as the formulas know it.
struct MillNumbers {
  double diameter = 0;  ///< [m] inside the liners
  double length = 0;    ///< [m] inside the end walls, or of a slice
  double speed = 0;     ///< [1] phi: share of the critical speed sqrt(2 g/D)
  double filling = 0;   ///< [1] J: bulk volume of the charge over that of the mill
  double density = 0;   ///< [kg/m3] of the charge in bulk, with its voids
};

/// Where a formula is given. Beyond, it is far from what it was fitted to, and may even be
/// negative.
struct FormulaRange {
  std::string_view name;      ///< "Bond's formula"
  std::string_view quantity;  ///< that is missing outside the range
  double least_speed, most_speed, least_filling, most_filling;  ///< [1] phi and J

  bool has(const MillNumbers& mill) const;
};
inline constexpr FormulaRange bond_range{"Bond's formula", "bond_power", 0.5, 0.9, 0.1, 0.5};
inline constexpr FormulaRange hogg_fuerstenau_range{
    "the formula of Hogg and Fuerstenau", "hogg_fuerstenau_power", 0.5, 0.9, 0.1, 0.5};
inline constexpr FormulaRange morrell_range{
    "Morrell's C model", "morrell_power", 0.48, 0.89, 0.05, 0.61};
inline constexpr std::array formula_ranges{bond_range, hogg_fuerstenau_range, morrell_range};

/// [W] Power at the shell by Bond (mil.1): of balls of `mass` [kg].
double bond_power(const MillNumbers& mill, double mass);
/// [W] Net power by Hogg and Fuerstenau (mil.2), at a lift angle [rad].
double hogg_fuerstenau_power(const MillNumbers& mill, double lift_angle);
constexpr double usual_lift_angle = 35 * 0.017453292519943295;  ///< [rad] of ball mills (mil.2)

/// The charge of Morrell's C model (mil.3 to mil.6).
struct MorrellCharge {
  double toe = 0, shoulder = 0;  ///< [rad] anticlockwise from 3 o'clock, in an anticlockwise mill
  double inner_radius = 0;       ///< [m] of the charge
  double power = 0;              ///< [W] of its motion, without the factor 1.26
};
MorrellCharge morrell_charge(const MillNumbers& mill);
constexpr double morrell_losses = 1.26;  ///< [1] losses within the charge and of the drive (mil.7)
/// [W] Power of the empty mill of cylindrical shape (mil.8).
double morrell_no_load_power(const MillNumbers& mill);

/// The mill of a case; none if it is no drum that turns about a lying axis with balls in it.
std::optional<MillNumbers> mill_numbers(const Case& c);

/// Whether a run of the case may have a power by the formula: the filling is in its range, and the
/// speed, unless that is known after the run.
bool may_hold(const FormulaRange& range, const Case& c);

/// Which formulas give no power for the mill of the case, and why. `rate`: mean speed of its run
/// over that of the case; none: before the run.
Notices mill_power_notices(const Case& c, std::optional<double> rate = std::nullopt);

}  // namespace mahlwerk::cases
