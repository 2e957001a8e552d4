// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "crowd_cases.hpp"

// A case of many balls as files, for programs that read their own kind of script.
namespace mahlwerk::bench {

/// In the laboratory frame, as it is after whole turns of the mill:
///   state.data  the balls, as LAMMPS and LIGGGHTS read them
///   case.in     every number of the case
///   jar.in      the jar as LAMMPS's region
///   jar.stl     the jar in triangles that touch its cylinder from outside
///   mesh.in     their motion, for LIGGGHTS
void write_crowd(const std::filesystem::path& folder, const CrowdCase& c,
                 const std::vector<scene::Ball>& balls);

}  // namespace mahlwerk::bench
