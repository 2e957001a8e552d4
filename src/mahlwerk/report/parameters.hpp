// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/campaign/fit/least_squares.hpp"

// Parameters that a fit or a calibration has estimated, as text and on pages.
namespace mahlwerk::report {

using campaign::FittedParameter, campaign::ParameterEstimates;

/// For the terminal: values with intervals; `head`: what a parameter is called.
std::string parameter_table(const ParameterEstimates& found, std::string_view head);
/// For the terminal: a line for each remark.
std::string remark_lines(const ParameterEstimates& found);

/// For a page: the value, struck out if the data do not determine it.
std::string value_cell_text(const FittedParameter& p);
/// For a page: a box for each parameter with remarks, and for those on the whole.
std::string remark_boxes(const ParameterEstimates& found);
/// For a page: the matrix with this number of decimals; empty for a single parameter. `what`:
/// "parameters".
std::string correlation_table(const ParameterEstimates& found, std::string_view what, int decimals);

}  // namespace mahlwerk::report
