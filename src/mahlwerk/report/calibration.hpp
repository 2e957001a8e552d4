// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/campaign/calibrate/calibration_job.hpp"

// Results of a calibration: text for the terminal, CSV table and page.
namespace mahlwerk::report {

using campaign::Calibration, campaign::FittedParameter, campaign::PredictedMeasurement;

std::string calibration_table(const Calibration& found);  ///< for the terminal
std::string calibration_csv(const Calibration& found);    ///< fit.csv (docs/formats.md)
std::string posterior_csv(const Calibration& found);      ///< posterior.csv
/// fit.html, a self-contained page.
std::string calibration_page(const Calibration& found, std::string_view version);
/// Explains intervals and predictions to the reader.
std::string how_to_read(const Calibration& found);

}  // namespace mahlwerk::report
