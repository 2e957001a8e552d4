// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "commands.hpp"

namespace mahlwerk::app {

/// The script of a job array whose tasks are the shards of a campaign: `request.slurm` of them.
std::string slurm_script(const Request& request, const std::filesystem::path& case_file,
                         const std::filesystem::path& place);

/// Writes it into the campaign's folder and submits it, and a job that joins the shards once all
/// have ended. Throws InputError where sbatch is missing or refuses; the script is there then.
int submit_to_slurm(const Request& request, const std::filesystem::path& case_file,
                    const std::filesystem::path& place);

}  // namespace mahlwerk::app
