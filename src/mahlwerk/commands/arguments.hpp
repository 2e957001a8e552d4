// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/places.hpp"

// Arguments that several commands share, and their options.
namespace mahlwerk::commands {

/// Changes of the case: --set, --unset, --seed.
struct Changes {
  std::vector<cases::Override> set;
  std::vector<std::string> unset;
  std::optional<std::uint64_t> seed;

  std::vector<cases::Override> overrides() const;  ///< all; --set counts after --unset
};

/// What commands that run cases are given: --out, --force, --jobs, --quiet, --json.
struct Running {
  std::optional<std::filesystem::path> out;
  bool force = false;
  int threads = 0;  ///< 0: all cores
  bool quiet = false, json = false;

  bool prints_text() const { return !quiet && !json; }
  bool prints_errors() const { return !quiet || json; }  ///< those of runs
};

/// What commands that run a case are given.
struct CaseArguments {
  std::string target;  ///< a case, or a folder of cases
  Changes changes;
  Running running;
};

Option one_case(std::string& target);       ///< CASE
Option several_cases(std::string& target);  ///< CASE, or a folder of cases
Options options_of(Changes& changes);
/// All but --json. The help names the default result folder, with `suffix`.
Options options_of(Running& running, std::string_view suffix = {});
Option threads(int& count);  ///< --jobs
Option quiet(bool& flag);    ///< --quiet
Option json(bool& flag);     ///< --json
/// --checkpoint [s]
Option checkpoint(std::optional<double>& interval, std::string_view about);
/// The same for commands that resume by themselves.
Option resumable_checkpoint(std::optional<double>& interval);

/// The lists, concatenated.
Options joined(std::initializer_list<Options> lists);

}  // namespace mahlwerk::commands
