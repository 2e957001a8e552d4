// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/geometry/surface.hpp"

// Bodies of one section along their length: liner bars, ribs.
namespace mahlwerk::geometry {

struct PlanePoint {
  double x = 0, y = 0;  ///< [m]
  bool operator==(const PlanePoint&) const = default;
};
/// Corners of a closed section, in order; the last is joined to the first.
using Section = std::vector<PlanePoint>;

/// Why a section bounds no area; empty if it is a polygon that does not cross itself.
std::string flaw_of(const Section& section);

/// [rad] Angle under which a section is seen from the origin; 2 pi if it holds the origin.
double angular_width(const Section& section);

/// The triangles, seen from outside, of a section without flaw along z from -length/2 to length/2,
/// with `copies` evenly about the z axis.
std::vector<Corners> prism(Section section, double length, int copies);

}  // namespace mahlwerk::geometry
