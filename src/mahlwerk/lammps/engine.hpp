// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/lammps/deck.hpp"
#include "mahlwerk/lammps/launch.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::lammps {

/// Writes the folder of a run: in.lammps, balls.data, case.toml and README.md. Removes what an
/// earlier run left there. Throws InputError if it cannot be written.
void write_folder(const std::filesystem::path& folder, const cases::Case& mill_case,
                  const scene::Chamber& chamber, const std::vector<scene::Ball>& balls,
                  const Steps& steps, int ranks);

/// Adds job.slurm to such a folder, a job script of Slurm to be submitted there; with more lines of
/// #SBATCH.
void write_slurm_script(const std::filesystem::path& folder, int ranks,
                        const std::vector<std::string>& options);

/// A run by LAMMPS as an engine: its process computes ahead, and advance() hands over the
/// collisions of what it has written, in rows of several steps; so a run goes on to the end of the
/// row in which the time lies. Throws InputError if LAMMPS is missing or lacks a package, RunError
/// where it stops.
std::unique_ptr<scene::Engine> make_engine(const cases::Case& mill_case,
                                           const scene::Chamber& chamber,
                                           const std::vector<scene::Ball>& balls,
                                           const Steps& steps, const Launch& launch);

}  // namespace mahlwerk::lammps
