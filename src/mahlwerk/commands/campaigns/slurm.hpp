// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mahlwerk/commands/arguments.hpp"
#include "mahlwerk/commands/campaigns/sweep_case.hpp"

namespace mahlwerk::commands {

/// What `sweep` is given. The target of its subcommands is the folder of a campaign.
struct SweepArguments : CaseArguments {
  CampaignPart part;
  int shards = 0;  ///< number of shards to submit to Slurm; 0: run here
  std::vector<std::string> slurm_options;
};

/// Throws InputError if `text` contains control characters: it must stay one line of a script.
void refuse_control(const std::string& where, const std::string& text);

/// The script of a Slurm job array with a task for each shard of the campaign.
std::string slurm_script(const SweepArguments& given, const std::filesystem::path& case_file,
                         const std::filesystem::path& place);

/// Writes the script into the campaign's folder and submits it, followed by a job that merges the
/// shards when all have ended. Throws InputError if sbatch is missing or fails; the script remains.
int submit_to_slurm(const SweepArguments& given, const std::filesystem::path& case_file,
                    const std::filesystem::path& place);

}  // namespace mahlwerk::commands
