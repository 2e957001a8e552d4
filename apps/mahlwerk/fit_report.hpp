// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/campaign/fit/job.hpp"
#include "mahlwerk/report/fit.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::app {

/// What was found, with curves through what was measured.
report::FitReport fit_report(const campaign::FitJob& job,
                             const std::vector<results::Outcome>& mills, const campaign::Fit& fit);

/// fit.json (docs/formats.md).
results::Json fit_json(const report::FitReport& fit, std::string_view version);

/// The case with what was found in place, and nothing left to be fitted.
cases::Case fitted_case(const campaign::FitJob& job, const report::FitReport& fit);

}  // namespace mahlwerk::app
