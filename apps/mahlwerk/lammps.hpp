// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "command.hpp"

// Runs by LAMMPS from the command line: `run --engine lammps --ranks 8`.
namespace mahlwerk::app {

/// --engine, --ranks, --write-only, --slurm and --slurm-option.
Options lammps_options();

/// Whether the folders for LAMMPS are all that is asked for.
bool writes_only(const Request& request);

/// Throws InputError if options and engines of the cases do not belong together, LAMMPS is missing,
/// or `root` holds a run that nobody asked to resume or to replace.
void check_lammps(const Request& request, const std::vector<cases::Case>& cases,
                  const std::filesystem::path& root);

/// Writes the folders of all replicates below `root`, and says what to do with them.
int write_for_lammps(const Request& request, const std::vector<cases::Case>& cases,
                     const std::filesystem::path& root);

}  // namespace mahlwerk::app
