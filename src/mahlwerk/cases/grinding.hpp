// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/powder/process.hpp"

// What a case says of grinding, in the terms of the physics.
namespace mahlwerk::cases {

/// Of a case with [capture] and [powder]; breakage and fragments are as they come without
/// [grinding].
powder::Process process(const Case& c);

/// [s] How long the mill works, pauses left out, as [grinding], [kinetics] or [heat] say; nothing
/// where none of them does.
std::optional<double> milling_time(const Case& c);

/// A number of [capture], [breakage], [fragments], [grinding] or [kinetics] that may be changed
/// after reading, without a new run of the mill: what `mahlwerk fit` chooses.
struct FitParameter {
  std::string key;  ///< "breakage.f_mat"
  std::string unit, about;
  Range range;  ///< in `unit`
};
/// Those this case has.
std::vector<FitParameter> fit_parameters(const Case& c);
/// Sets one of them, in its unit. Throws std::invalid_argument for another key.
void set_fit_parameter(Case& c, const std::string& key, double value);
double fit_parameter_value(const Case& c, const std::string& key);  ///< its value now

}  // namespace mahlwerk::cases
