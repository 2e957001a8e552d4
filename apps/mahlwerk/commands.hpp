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

// The request that a command line makes, and functions that the commands share.
namespace mahlwerk::app {

/// The parsed command line.
struct Request {
  std::string target;  ///< case, catalogue category or name, or folder of a campaign
  std::string data;    ///< of `fit`: the table of measurements; of `match`: the other mill
  std::vector<cases::Override> set;
  std::string mill, kind, jar, jar_kind, balls;  ///< of `new`
  std::optional<std::filesystem::path> out;
  std::optional<std::uint64_t> seed;
  int settings = 0;   ///< of `fit`: largest number of settings; 0: as many as usual
  int threads = 0;    ///< 0: all cores
  std::string shard;  ///< "2/8": the second of eight parts of a campaign; empty: all
  int slurm = 0;      ///< number of shards to submit to Slurm; 0: run here
  std::vector<std::string> slurm_options;
  std::string engine;       ///< replaces run.engine; empty: as the case says
  int ranks = 0;            ///< processes of one run by LAMMPS; 0: by cores and balls
  bool write_only = false;  ///< of `run`: write the folders of LAMMPS, start nothing
  bool slurm_job = false;   ///< of `run`: the same, with a job script of Slurm
  std::string results;  ///< results kept of a campaign: "all", "summary"; empty: by their number
  std::optional<double> checkpoint;  ///< [s] interval between two checkpoints of the run
  bool resume = false;               ///< resume from the last checkpoint
  bool quiet = false, json = false, force = false;
  std::vector<std::string> quantities;  ///< of `surrogate` and `ask`; empty: the usual ones
  bool quick_only = false;              ///< of `papers`: without those that take long
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

/// The version of this build, and its catalogue (base/data_folder.hpp).
std::string_view version();
cases::Catalogue catalogue();

/// The case files that `target` names: the file itself, the folder's case.toml, or else every .toml
/// in the folder. Throws InputError if there is none.
std::vector<std::filesystem::path> case_files(const std::string& target);

/// The single case file that `target` names, for a command ("fit") that takes one. Throws
/// InputError if there are several.
std::filesystem::path one_case_file(const std::string& target, std::string_view command);

/// The default result folder: results/ and the name of the folder or file that the user gave,
/// followed by the case's name if there are several cases.
std::filesystem::path default_folder(const std::string& target, const std::filesystem::path& file,
                                     bool several);

/// Reports on stderr if a run did not complete. Returns the exit code.
int report_exit_status(const std::vector<results::Outcome>& outcomes);

/// The overrides of --set and --seed.
std::vector<cases::Override> overrides(const Request& request);

}  // namespace mahlwerk::app
