// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/campaign/fit/fit.hpp"

// Results of a fit: text for the terminal, CSV table and page.
namespace mahlwerk::report {

using campaign::Fit, campaign::FitCurve, campaign::FittedParameter, campaign::PredictedMeasurement;

/// Explains residuals, intervals and scatter to the reader.
std::string how_to_read(const Fit& fit);

std::string fit_table(const Fit& fit);  ///< for the terminal
std::string fit_csv(const Fit& fit);    ///< fit.csv (docs/formats.md)
/// fit.html, a self-contained page.
std::string fit_page(const Fit& fit, std::string_view version);

}  // namespace mahlwerk::report
