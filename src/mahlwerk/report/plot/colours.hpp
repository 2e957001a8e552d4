// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

// Colours of plots: scales that most colour-blind readers can distinguish, and those of text and
// lines. SVG text has them as plain attributes, because programs that convert SVG do not read CSS
// variables; the dark mode of pages replaces them by the values of the attributes (page.cpp).
namespace mahlwerk::report {

constexpr std::string_view ink_colour = "#1d2329";     ///< titles, labels, marks of measured values
constexpr std::string_view soft_colour = "#59636e";    ///< axes and their ticks
constexpr std::string_view grid_colour = "#e3e6ea";    ///< grid
constexpr std::string_view ground_colour = "#ffffff";  ///< ground of the picture
constexpr std::string_view failed_colour = "#f5f7f9";  ///< cell of a map without a value

/// The viridis colour at `share`, from 0 (dark blue) to 1 (yellow): "#440154".
std::string viridis(double share);

/// Text colour with contrast on viridis at `share`.
std::string_view ink_on_viridis(double share);

/// Categorical colours of Okabe and Ito; they repeat after seven.
std::string_view kind_colour(std::size_t kind);
std::string_view ink_on_kind(std::size_t kind);

}  // namespace mahlwerk::report
