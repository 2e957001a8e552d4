// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/campaign/fit/job.hpp"
#include "mahlwerk/report/fit.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::commands {

/// The result of the fit, with model curves through the measured values.
report::FitReport fit_report(const campaign::FitJob& job,
                             const std::vector<results::Outcome>& mills, const campaign::Fit& fit);

/// fit.json (docs/formats.md).
results::Json fit_json(const report::FitReport& fit, std::string_view version);

/// The case with the fitted values set and the list of parameters to fit cleared.
cases::Case fitted_case(const campaign::FitJob& job, const report::FitReport& fit);

/// "mill.speed = 300 rpm, ..."; empty without overrides.
std::string condition_label(const std::vector<cases::Override>& condition);

}  // namespace mahlwerk::commands
