// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "commands.hpp"

namespace mahlwerk::app {

/// Throws InputError if `text` contains control characters: it must stay one line of a script.
void refuse_control(const std::string& where, const std::string& text);

/// The script of a Slurm job array with `request.slurm` tasks, one for each shard of the campaign.
std::string slurm_script(const Request& request, const std::filesystem::path& case_file,
                         const std::filesystem::path& place);

/// Writes the script into the campaign's folder and submits it, followed by a job that merges the
/// shards when all have ended. Throws InputError if sbatch is missing or fails; the script remains.
int submit_to_slurm(const Request& request, const std::filesystem::path& case_file,
                    const std::filesystem::path& place);

}  // namespace mahlwerk::app
