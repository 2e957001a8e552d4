// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/runs/lammps.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/lammps_runs.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/commands/campaigns/slurm.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"
#include "mahlwerk/lammps/program.hpp"

namespace mahlwerk::commands {
namespace {

namespace fs = std::filesystem;

bool by_lammps(const cases::Case& mill_case) {
  return mill_case.run.engine == cases::EngineName::lammps;
}

void refuse(const std::string& where, std::string what, std::string remedy) {
  throw InputError(Fault{where, std::move(what), std::move(remedy), "lammps"});
}

/// Ranks on another machine, whose cores are not known: one for 20 000 balls.
int ranks_elsewhere(const cases::Case& mill_case) {
  constexpr std::int64_t balls_per_rank = 20'000;
  return static_cast<int>(1 + (cases::balls_count(mill_case.balls) - 1) / balls_per_rank);
}

/// The first folder below `root` in which a run has begun; empty if there is none.
fs::path begun_below(const fs::path& root) {
  std::error_code error;
  for (fs::recursive_directory_iterator at(root, error), end; !error && at != end;
       at.increment(error))
    if (at->path().filename() == "from.0.txt") return at->path().parent_path();
  return {};
}

}  // namespace

Options lammps_options(LammpsArguments& given) {
  return {{.name = "--engine",
           .target = &given.engine,
           .about = "engine that computes the run; replaces run.engine",
           .type = "NAME",
           .values = {"event", "soft", "auto", "lammps"},
           .completions = "event soft auto lammps"},
          {.name = "--ranks",
           .target = &given.ranks,
           .about = "with LAMMPS: number of processes of one run (default: cores, of at least 2000 "
                    "balls each; elsewhere one for 20 000 balls)",
           .range = {1, 1000000}},
          {.name = "--write-only",
           .target = &given.write_only,
           .about = "with LAMMPS: write the folder of the run for another machine, start nothing"},
          {.name = "--slurm",
           .target = &given.slurm,
           .about = "with LAMMPS: the same, with a job script of Slurm"},
          {.name = "--slurm-option",
           .target = &given.slurm_options,
           .about = "a line of the job script: --slurm-option partition=long; may be repeated",
           .needs = "--slurm"}};
}

void check_lammps(const LammpsArguments& given, bool force, const std::vector<cases::Case>& cases,
                  const fs::path& root) {
  const auto many = std::ranges::count_if(cases, by_lammps);
  const bool asks = given.writes_only() || given.ranks > 0;
  if (many == 0 && !asks) return;
  if (asks && !std::ranges::all_of(cases, [](const auto& c) { return c.sweep.empty(); }))
    refuse("--ranks, --write-only, --slurm", "a case has [sweep], whose runs have one rank each",
           "leave out these options, or run the settings as cases of their own");
  if (std::cmp_less(many, cases.size()) && (asks || given.resume)) {
    refuse("--engine", "some of the cases have another engine than \"lammps\"",
           "give --engine lammps, or leave out --ranks, --write-only, --slurm and --resume");
  }
  for (const std::string& option : given.slurm_options)
    refuse_control("--slurm-option " + option, option);
  if (const fs::path begun = begun_below(root); !begun.empty() && !given.resume && !force)
    refuse(begun.string(), "LAMMPS has begun a run in this folder",
           "give --resume to go on with it or read its results, --force to begin again, or another "
           "--out");
  if (given.writes_only()) return;
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  if (given.ranks > cores)
    refuse("--ranks",
           fmt::format("{} ranks on {} cores would wait for each other", given.ranks, cores),
           fmt::format("give --ranks {} or less, or --write-only for another machine", cores));
  const lammps::Installed lmp = lammps::installed(std::max(1, given.ranks));
  if (!lmp.faults.empty()) throw InputError(lmp.faults);
}

int write_for_lammps(const LammpsArguments& given, const Running& running,
                     const std::vector<cases::Case>& cases, const fs::path& root) {
  results::Json written = results::Json::array();
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const lammps::Launch launch{
        .folder = cases.size() > 1 ? root / fmt::format("point-{}", i + 1) : root,
        .ranks = given.ranks > 0 ? given.ranks : ranks_elsewhere(cases[i])};
    for (const fs::path& folder :
         campaign::write_lammps_folders(cases[i], launch, given.slurm, given.slurm_options)) {
      written.push_back(folder.string());
      if (running.prints_text())
        to_stdout(fmt::format(
            "written:  {}\nto run:   cd {} && {}\n", folder.string(), shell_word(folder.string()),
            given.slurm ? "sbatch job.slurm"
                        : fmt::format("mpirun -np {} lmp -in in.lammps", launch.ranks)));
    }
  }
  if (running.json) json_to_stdout(written);
  if (running.prints_text())
    to_stdout("results:  this command with --resume instead, once LAMMPS has ended\n");
  return success;
}

}  // namespace mahlwerk::commands
