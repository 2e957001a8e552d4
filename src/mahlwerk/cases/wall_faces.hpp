// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/cases/case.hpp"

// The faces that balls can hit: those of the jar, then those of the parts, one part after the
// other.
namespace mahlwerk::cases {

int jar_faces(const Case& c);
int wall_faces(const Case& c);  ///< of jar and parts
/// Of each face: "jar.side", "parts.stirrer"; the faces of a part have one name.
std::vector<std::string> wall_face_names(const Case& c);
/// The part of each face after those of the jar, by its index.
std::vector<int> parts_of_faces(const Case& c);
/// [m/s] Bound of the speed of the parts, relative to the jar or in the laboratory.
double part_speed(const Case& c);
/// [s] The longest period of a part that moves; infinite without one.
double part_period(const Case& c);
/// What of the jar the event engine cannot compute, "a jar of kind \"mesh\""; empty if nothing.
std::string soft_only_wall(const Case& c);

}  // namespace mahlwerk::cases
