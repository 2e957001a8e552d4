// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/report/methods.hpp"
#include "mahlwerk/report/record/models.hpp"
#include "mahlwerk/results/files/json_value.hpp"

namespace mahlwerk::commands {

/// A run, read from its result folder.
struct RecordedRun {
  cases::Case mill_case;  ///< case.resolved.toml, with the origins of the run
  results::Json summary;  ///< summary.json
  report::RunState state;
  report::CountedRuns counted;
  std::string version;  ///< of the program that ran it
};

/// Whether the folder holds the result of a run.
bool holds_run(const std::filesystem::path& folder);

/// Reads a result folder. Throws InputError if it is missing, if it is the folder of a campaign or
/// of something else, or if a file is damaged.
RecordedRun recorded_run(const std::filesystem::path& folder);

}  // namespace mahlwerk::commands
