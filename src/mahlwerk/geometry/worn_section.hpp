// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "mahlwerk/geometry/prism.hpp"

// A section that wears: its sides move inwards. Side i joins corner i to the next one. Sections are
// anticlockwise.
namespace mahlwerk::geometry {

double area_of(const Section& section);                      ///< [m2] > 0 if anticlockwise
double length_of(const Section& section, std::size_t side);  ///< [m]

/// The section as it is, anticlockwise, its sides cut into equal pieces of `longest` [m] at most.
Section cut_into_pieces(Section section, double longest);

/// The side that is nearest to a point.
std::size_t nearest_side(const Section& section, const PlanePoint& p);

/// Spreads what sides lost along the section, as heat is conducted, with the standard deviation
/// `width` [m] >= 0; only between neighbours that are `exposed`. The sum stays, and a uniform depth
/// (wea.11).
std::vector<double> spread_along(const Section& section, std::vector<double> lost,
                                 const std::vector<bool>& exposed, double width);

/// The section whose sides have lost these areas [m2] >= 0 (wea.12). Its area is smaller by their
/// sum, to rounding. None if it would cross itself or be gone.
std::optional<Section> worn_section(const Section& section, const std::vector<double>& lost);

/// The section without sides shorter than `shortest` [m]: such a side becomes a corner that keeps
/// the area. Its neighbours are not below three sides.
Section without_short_sides(Section section, double shortest);

/// [1] Share of a circle about the origin that is inside the section.
double share_of_circle(const Section& section, double radius);

}  // namespace mahlwerk::geometry
