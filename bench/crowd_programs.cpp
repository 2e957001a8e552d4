// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "crowd_programs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <fstream>

#include "child.hpp"

namespace mahlwerk::bench {
namespace {

namespace fs = std::filesystem;

constexpr double time_limit = 300;  // [s]

std::vector<std::string> command_of(Peer peer, int steps, int cores) {
  const CrowdProgram& program = crowd_programs[peer];
  const std::string command(program.command);
  const std::string deck = fmt::format("{}/bench/peers/{}", MAHLWERK_HOME, program.deck);
  if (peer == yade) return {command, fmt::format("-j{}", cores), "-n", "-x", deck};
  std::vector<std::string> words;
  if (cores > 1) words = {"mpirun", "--oversubscribe", "-np", fmt::format("{}", cores)};
  for (const std::string& word :
       {command, std::string("-in"), deck, std::string("-log"), std::string("log.txt"),
        std::string("-screen"), std::string("screen.txt"), std::string("-var"),
        std::string("steps"), fmt::format("{}", steps)})
    words.push_back(word);
  return words;
}

/// Reads speed and energy from a log in the format of LAMMPS, which the decks for the other codes
/// use, too.
ProgramResult read_log(const fs::path& log, int last_step) {
  ProgramResult result{NAN, NAN, NAN, 0, {}};
  double particle_steps = NAN;
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) {
    double moving = 0, spinning = 0, seconds = 0;
    int step = 0, steps = 0, balls = 0;
    if (std::sscanf(line.c_str(), "%d %lf %lf", &step, &moving, &spinning) == 3 &&
        step == last_step)
      result.kinetic = moving + spinning;
    if (std::sscanf(line.c_str(), "Loop time of %lf on %*d procs for %d steps with %d atoms",
                    &seconds, &steps, &balls) == 3) {
      particle_steps = static_cast<double>(balls) * steps;
      result.speed = particle_steps / seconds;
    }
    if (std::sscanf(line.c_str(), "CPU time of %lf", &seconds) == 1)
      result.cost = seconds / particle_steps;
  }
  return result;
}

ProgramResult run_program(const Child& child, int last_step) {
  for (const char* name : {"log.txt", "errors.txt"}) fs::remove(child.folder / name);
  const ChildResult ended = watch_child(child, [](std::string_view) {});
  ProgramResult result = read_log(child.folder / "log.txt", last_step);
  result.memory = ended.peak_memory;
  result.fault = ended.fault;
  if (result.fault.empty() && !std::isfinite(result.speed)) result.fault = "did not finish";
  if (result.fault.empty() && !std::isfinite(result.kinetic))
    result.fault = "lost its balls: their energy is not a number";
  const std::string said = result.fault.empty() ? "" : complaint(child.folder);
  if (!said.empty()) result.fault += ": " + said;
  return result;
}

}  // namespace

ProgramResult run_mahlwerk(const CrowdRun& run, const fs::path& folder) {
  std::vector<std::string> words = arguments_for(run);
  words.insert(words.begin(), fs::read_symlink("/proc/self/exe"));
  return run_program({words, folder, {}, time_limit}, run.lead + run.steps);
}

ProgramResult run_peer(Peer peer, const fs::path& folder, int steps, int cores) {
  // Open MPI refuses to run as root, the usual user in containers, unless both variables allow it.
  const Child child{
      command_of(peer, steps, cores),
      folder,
      {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
       fmt::format("OMP_NUM_THREADS={}", peer == yade ? cores : 1), fmt::format("STEPS={}", steps)},
      time_limit};
  return run_program(child, steps);
}

bool is_installed(Peer peer, int cores) {
  if (find_program(crowd_programs[peer].command).empty()) return false;
  return cores == 1 || peer == yade || !find_program("mpirun").empty();
}

}  // namespace mahlwerk::bench
