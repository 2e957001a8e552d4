// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/report/plot/svg_plot.hpp"

namespace mahlwerk::report {

/// A whole HTML page around `body`: one file, nothing loaded from elsewhere, light or dark as the
/// reader's screen is, and made to be printed.
std::string page(std::string_view title, std::string_view body, std::string_view footer);

/// A plot with a sentence below it.
std::string figure(const Plot& plot, std::string_view caption);

}  // namespace mahlwerk::report
