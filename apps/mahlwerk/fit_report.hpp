// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/campaign/fit/fit.hpp"
#include "mahlwerk/report/fit.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::app {

/// A case with what was measured of it, and the mills that stand for it.
struct FitJob {
  cases::Case base;  ///< as the case file says, free numbers anywhere in their ranges
  std::string data_file;
  campaign::Measurements data;
  std::vector<campaign::FreeParameter> numbers;
  std::vector<cases::Case> mills;  ///< of each condition
};

/// What was found, with curves through what was measured.
report::FitReport fit_report(const FitJob& job, const std::vector<results::Outcome>& mills,
                             const campaign::Fit& fit);

/// fit.json (docs/formats.md).
results::Json fit_json(const report::FitReport& fit, std::string_view version);

/// The case with what was found in place, and nothing left to be fitted.
cases::Case fitted_case(const FitJob& job, const report::FitReport& fit);

}  // namespace mahlwerk::app
