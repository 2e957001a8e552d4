// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mahlwerk/base/field.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/powder/process.hpp"

// Converts the sections on grinding of a case to the types of the powder models.
namespace mahlwerk::cases {

/// The grinding process of a case with [capture] and [powder]. Without [grinding], breakage and
/// fragments have their default values.
powder::Process process(const Case& c);

/// [s] Milling time without pauses: of [milling], which [grinding], [kinetics] and [heat]
/// share, or of one of these; no value if the case states none.
std::optional<double> milling_time(const Case& c);

/// A number of [capture], [breakage], [fragments], [grinding] or [kinetics] that `mahlwerk fit` may
/// change without a new run of the mill.
struct FitParameter {
  std::string key;  ///< "breakage.f_mat"
  std::string unit, about;
  Range range;  ///< in `unit`
};
/// The fit parameters of this case.
std::vector<FitParameter> fit_parameters(const Case& c);
/// Sets a fit parameter, in its unit. Throws std::invalid_argument for another key.
void set_fit_parameter(Case& c, const std::string& key, double value);
/// The value of a fit parameter, in its unit. Throws std::invalid_argument for another key.
double fit_parameter_value(const Case& c, const std::string& key);

}  // namespace mahlwerk::cases
