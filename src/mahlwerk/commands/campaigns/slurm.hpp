// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

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

/// Tasks that a job array may have, by what `scontrol show config` prints: their numbers are below
/// MaxArraySize. 1000, as Slurm has without configuration, where it prints no such line.
int most_tasks(const std::string& configuration);

/// Job arrays, each with at most `most` tasks, that have a task for each shard: the number of the
/// shard before the first task of each, and its tasks.
struct JobArray {
  int before = 0, tasks = 0;
};
std::vector<JobArray> job_arrays(int shards, int most);

/// The script of Slurm job arrays with a task for each shard of the campaign. `fingerprint` is that
/// of the campaign as it is submitted.
std::string slurm_script(const SweepArguments& given, const std::filesystem::path& case_file,
                         const std::filesystem::path& place, const std::string& fingerprint,
                         const std::vector<JobArray>& arrays);

/// The fingerprint of the campaign in the script of a folder; empty if there is none.
std::string submitted_fingerprint(const std::filesystem::path& place);

/// Writes the script into the campaign's folder and submits it, in as many arrays as the cluster
/// needs, followed by a job that merges the shards when all have ended. Throws InputError if sbatch
/// is missing or fails; the script remains.
int submit_to_slurm(const SweepArguments& given, const cases::Case& mill_case,
                    const std::filesystem::path& case_file, const std::filesystem::path& place);

}  // namespace mahlwerk::commands
