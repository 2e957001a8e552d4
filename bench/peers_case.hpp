// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

#include "peers.hpp"

// Writes the case as files for programs with their own kind of script.
namespace mahlwerk::bench {

/// Every number of the case and the positions of the balls, as lines "variable NAME equal VALUE",
/// which LAMMPS and LIGGGHTS include. Positions are in the laboratory frame. Its origin is where
/// the disc's axis meets the vial's floor.
void write_case(const std::filesystem::path& file, const Start& start);

/// The closed vial at time 0 as triangles (STL). Its polygon of `sides` has the vial's radius on
/// average.
void write_vial(const std::filesystem::path& file, int sides = 72);

}  // namespace mahlwerk::bench
