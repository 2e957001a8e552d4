// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "mahlwerk/report/plot/map.hpp"
#include "mahlwerk/report/plot/plot.hpp"

namespace mahlwerk::report {

/// A complete HTML page around `body`: self-contained, with light and dark mode and a print style.
std::string page(std::string_view title, std::string_view body, std::string_view footer);

/// A page of this or an earlier version with the style and the scripts of this one; its words and
/// numbers stay. nullopt if it is no page of Mahlwerk.
std::optional<std::string> renewed_page(std::string_view old);

/// A box with a note or a warning in HTML.
std::string note_box(const std::string& words, bool warns);

/// A plot with a caption (plain text) as HTML <figure>.
std::string figure(const Plot& plot, std::string_view caption);
/// The same of a map; empty without one.
std::string figure(const std::optional<ColourMap>& map, std::string_view caption);

}  // namespace mahlwerk::report
