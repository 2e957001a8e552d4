// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/outcome.hpp"

// The commands of the program: a row each, a file each.
namespace mahlwerk::app {

/// The options and parts of a command: what a shell may offer after its name.
struct CommandWords {
  std::string command;  ///< "run", "sweep status"; empty: of the program
  std::vector<std::string> words;
};

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
  std::vector<CommandWords> commands;  ///< all there are, for completion
};

/// Exit codes (docs/cli.md).
enum Exit : int {
  fine = 0,
  internal_error = 1,
  bad_input = 2,
  stopped_by_physics = 3,
  output_lost = 4,
  interrupted = 130
};

int run(const Request& request);
int sweep(const Request& request);
int sweep_status(const Request& request);
int sweep_export(const Request& request);
int sweep_retry(const Request& request);
int sweep_merge(const Request& request);
int compare(const Request& request);
int fit(const Request& request);
int optimise(const Request& request);
int match(const Request& request);
int papers(const Request& request);
int check(const Request& request);
int list(const Request& request);
int describe(const Request& request);
int completion(const Request& request);

/// Which options a command takes.
enum class Takes {
  case_file,
  run,
  sweep,
  compare,
  fit,
  search,
  match,
  papers,
  campaign,
  room,
  name,
  shell
};

struct Command {
  std::string_view name, about;
  Takes takes;
  int (*perform)(const Request&);
  std::string_view of = "";  ///< the command it is a part of: "sweep status"
};

inline constexpr std::array commands{
    Command{"run", "run a case, or every case of a folder, and write its results", Takes::run, run},
    Command{"sweep", "run the campaign of a case with [sweep], or go on with it", Takes::sweep,
            sweep},
    Command{"status", "how far a campaign is, and what failed", Takes::campaign, sweep_status,
            "sweep"},
    Command{"export", "the table of a campaign as CSV", Takes::campaign, sweep_export, "sweep"},
    Command{"retry", "run what failed once more", Takes::campaign, sweep_retry, "sweep"},
    Command{"merge", "join the shards of a campaign", Takes::campaign, sweep_merge, "sweep"},
    Command{"compare", "run a case by both engines and show the results side by side",
            Takes::compare, compare},
    Command{"fit", "find numbers of a case from what was measured of the powder, with intervals",
            Takes::fit, fit},
    Command{"optimise", "find the settings for which a quantity is best: [optimise] of the case",
            Takes::search, optimise},
    Command{"match", "find the settings of one mill that do to the powder what another mill does",
            Takes::match, match},
    Command{"papers", "regenerate every figure of a paper and put its claims to the test",
            Takes::papers, papers},
    Command{"check", "read a case without running it: its faults, or what follows from it",
            Takes::case_file, check},
    Command{"list", "list what the catalogue holds: mills, jars, materials or media", Takes::room,
            list},
    Command{"describe", "show one catalogue entry: all values with units and sources", Takes::name,
            describe},
    Command{"completion", "print a completion script for your shell: bash or zsh", Takes::shell,
            completion},
};

/// The version of this build, and its catalogue: MAHLWERK_CATALOGUE, or the one it was built with.
std::string_view version();
cases::Catalogue catalogue();

/// The case files a user means: the file itself, the folder's case.toml, or else every .toml in the
/// folder.
std::vector<std::filesystem::path> case_files(const std::string& target);

/// Makes a folder and those above it, unless it is there. Throws InputError where it cannot.
void make_folder(const std::filesystem::path& place);

/// The one case file that is meant, for a command ("fit") that takes no more.
std::filesystem::path one_case_file(const std::string& target, std::string_view command);

/// results/ and the name of the folder or file the user gave, with each case's name if there are
/// several.
std::filesystem::path default_place(const std::string& target, const std::filesystem::path& file,
                                    bool several);

/// The campaign of a case with [sweep], all of it or request.shard, in the folder `place`.
int sweep_case(const Request& request, const std::filesystem::path& file,
               const std::vector<cases::Override>& set, const std::filesystem::path& place);

/// Says on stderr if a run did not end as asked; the exit code.
int how_it_ended(const std::vector<results::Outcome>& outcomes);

/// --set and --seed together.
std::vector<cases::Override> overrides(const Request& request);

}  // namespace mahlwerk::app
