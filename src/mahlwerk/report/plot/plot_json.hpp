// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/report/plot/svg_plot.hpp"

namespace mahlwerk::report {

/// A text as a JSON string that may stand inside a <script> element.
std::string json_string(std::string_view text);

/// The plot as JSON, which the script of the page draws (web/src/plot/README.md).
std::string plot_json(const Plot& plot);

/// The content of a <figure>: the data that the script draws, or for browsers without scripts the
/// picture `svg`. Without data only the picture.
std::string drawing(std::string_view svg, std::string_view json);

}  // namespace mahlwerk::report
