// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "crowd_cases.hpp"

// Writes a case with many balls as files for programs with their own kind of script.
namespace mahlwerk::bench {

/// Writes the case in the laboratory frame, in its state after whole turns of the mill:
///   state.data  the balls, as LAMMPS and LIGGGHTS read them
///   case.in     every number of the case
///   jar.in      the jar as a region of LAMMPS
///   jar.stl     the jar as triangles that touch its cylinder from outside
///   mesh.in     the motion of the triangles, for LIGGGHTS
void write_crowd(const std::filesystem::path& folder, const CrowdCase& c,
                 const std::vector<scene::Ball>& balls);

}  // namespace mahlwerk::bench
