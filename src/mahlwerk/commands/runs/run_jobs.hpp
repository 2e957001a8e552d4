// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/cases/wear.hpp"
#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/runs/lammps.hpp"
#include "mahlwerk/results/files/folder.hpp"

// What `mahlwerk run` computes: cases and their result folders.
namespace mahlwerk::commands {

struct RunArguments : CaseArguments {
  LammpsArguments lammps;
  std::optional<double> checkpoint;  ///< [s] interval between two checkpoints
  bool no_checkpoint = false;

  std::vector<cases::Override> overrides() const {
    std::vector<cases::Override> all = changes.overrides();
    if (!lammps.engine.empty()) all.push_back({"run.engine", lammps.engine});
    return all;
  }
};

/// A case and its result folder.
struct RunJob {
  cases::CaseFile source;
  cases::Case mill_case;
  std::filesystem::path file, place;
  std::unique_ptr<results::Folder>
      folder;  ///< null for a campaign or wear over time, with their own

  bool sweeps() const { return !mill_case.sweep.empty(); }
  /// Whether shapes and sizes follow their wear, stage by stage.
  bool evolves() const { return cases::evolves(mill_case); }
};

/// Reads all cases and checks all result folders before anything is computed. A target that is no
/// file but the name of a mill is the case that `mahlwerk new` proposes for it, with all assumed
/// values varied. Throws InputError.
std::vector<RunJob> prepare_all(const RunArguments& given);

/// The folder of all runs by LAMMPS, beside the results.
std::filesystem::path lammps_root(const std::vector<RunJob>& jobs);
std::vector<cases::Case> cases_of(const std::vector<RunJob>& jobs);

}  // namespace mahlwerk::commands
