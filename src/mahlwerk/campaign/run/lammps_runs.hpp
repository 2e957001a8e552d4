// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/lammps/deck.hpp"
#include "mahlwerk/lammps/launch.hpp"

// Runs of engine = "lammps".
namespace mahlwerk::campaign {

/// Steps of such a run: those of the soft engine.
lammps::Steps lammps_steps(const cases::Case& mill_case, const SoftSettings& s);

/// Ranks of one run on `cores` cores: at least 2000 balls for each rank.
int usual_ranks(const cases::Case& mill_case, int cores);

/// The folder of a replicate below `root`: replicate-1, or point-1/replicate-1 if there are several
/// points.
std::filesystem::path lammps_folder(const std::filesystem::path& root, std::size_t point,
                                    std::size_t points, int replicate);

/// Writes the folders of all replicates for a run elsewhere, with a job script of Slurm if `slurm`.
/// Returns their folders.
std::vector<std::filesystem::path> write_lammps_folders(
    const cases::Case& mill_case, const lammps::Launch& launch, bool slurm,
    const std::vector<std::string>& slurm_options);

}  // namespace mahlwerk::campaign
