// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "mahlwerk/commands/arguments.hpp"

// Runs by LAMMPS from the command line: `run --engine lammps --ranks 8`.
namespace mahlwerk::commands {

/// What `run` is given for LAMMPS.
struct LammpsArguments {
  std::string engine;       ///< replaces run.engine; empty: as the case says
  int ranks = 0;            ///< processes of one run; 0: by cores and balls
  bool write_only = false;  ///< write the folders of the runs, start nothing
  bool slurm = false;       ///< the same, with a job script of Slurm
  std::vector<std::string> slurm_options;
  bool resume = false;  ///< go on with what the folders hold

  /// Whether the folders for LAMMPS are all that is asked for.
  bool writes_only() const { return write_only || slurm; }
};

/// --engine, --ranks, --write-only, --slurm and --slurm-option.
Options lammps_options(LammpsArguments& given);

/// Throws InputError if options and engines of the cases do not belong together, LAMMPS is missing,
/// or `root` holds a run that nobody asked to resume or, by `force`, to replace.
void check_lammps(const LammpsArguments& given, bool force, const std::vector<cases::Case>& cases,
                  const std::filesystem::path& root);

/// Writes the folders of all replicates below `root`, and says what to do with them.
int write_for_lammps(const LammpsArguments& given, const Running& running,
                     const std::vector<cases::Case>& cases, const std::filesystem::path& root);

}  // namespace mahlwerk::commands
