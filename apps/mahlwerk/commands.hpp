// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/outcome.hpp"

// What a command line asks for, and what the commands share.
namespace mahlwerk::app {

/// What the command line said.
struct Request {
  std::string target;  ///< case, room, name, or folder of a campaign
  std::string data;    ///< the table of measurements, of fit; the other mill, of match
  std::vector<cases::Override> set;
  std::optional<std::filesystem::path> out;
  std::optional<std::uint64_t> seed;
  int threads = 0;    ///< 0: all cores
  std::string shard;  ///< "2/8" of a campaign; empty: all of it
  int slurm = 0;      ///< shards to be submitted to Slurm; 0: run here
  std::vector<std::string> slurm_options;
  std::string results;  ///< of a campaign's runs: "all" or "summary"; empty: by their number
  std::optional<double> checkpoint;  ///< [s] between two states of the run that are kept
  bool resume = false;               ///< go on from the last of them
  bool quiet = false, json = false, force = false;
};

/// Exit codes (docs/cli.md).
enum Exit : int {
  success = 0,
  internal_error = 1,
  bad_input = 2,
  stopped_by_physics = 3,
  output_lost = 4,
  interrupted = 130
};

/// The version of this build, and its catalogue: MAHLWERK_CATALOGUE, or the one it was built with.
std::string_view version();
cases::Catalogue catalogue();

/// The case files a user means: the file itself, the folder's case.toml, or else every .toml in the
/// folder.
std::vector<std::filesystem::path> case_files(const std::string& target);

/// The one case file that is meant, for a command ("fit") that takes no more.
std::filesystem::path one_case_file(const std::string& target, std::string_view command);

/// results/ and the name of the folder or file the user gave, with each case's name if there are
/// several.
std::filesystem::path default_folder(const std::string& target, const std::filesystem::path& file,
                                     bool several);

/// Says on stderr if a run did not end as asked; the exit code.
int report_exit_status(const std::vector<results::Outcome>& outcomes);

/// --set and --seed together.
std::vector<cases::Override> overrides(const Request& request);

}  // namespace mahlwerk::app
