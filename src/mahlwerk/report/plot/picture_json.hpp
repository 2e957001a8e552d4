// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/report/plot/bars.hpp"
#include "mahlwerk/report/plot/map.hpp"
#include "mahlwerk/report/plot/plot.hpp"

// Pictures of a page as data, which the script of the page draws (web/README.md, "Pictures").
namespace mahlwerk::report {

/// A text as a JSON string that may stand inside a <script> element.
std::string json_string(std::string_view text);

std::string picture_json(const Plot& plot);
std::string picture_json(const BarPlot& plot);
std::string picture_json(const ColourMap& map);

/// The element of a page that holds the data of a picture.
std::string drawing(std::string_view json);

}  // namespace mahlwerk::report
