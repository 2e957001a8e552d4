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

constexpr double patience = 300;  // [s]

std::vector<std::string> words_of(Peer peer, int steps, int cores) {
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

/// Speed and energy, from the words of LAMMPS, which the decks for others use, too.
Told told_in(const fs::path& log, int last_step) {
  Told told{NAN, NAN, NAN, 0, {}};
  double particle_steps = NAN;
  std::ifstream file(log);
  for (std::string line; std::getline(file, line);) {
    double moving = 0, spinning = 0, seconds = 0;
    int step = 0, steps = 0, balls = 0;
    if (std::sscanf(line.c_str(), "%d %lf %lf", &step, &moving, &spinning) == 3 &&
        step == last_step)
      told.kinetic = moving + spinning;
    if (std::sscanf(line.c_str(), "Loop time of %lf on %*d procs for %d steps with %d atoms",
                    &seconds, &steps, &balls) == 3) {
      particle_steps = static_cast<double>(balls) * steps;
      told.speed = particle_steps / seconds;
    }
    if (std::sscanf(line.c_str(), "CPU time of %lf", &seconds) == 1)
      told.cost = seconds / particle_steps;
  }
  return told;
}

Told told_by(const Child& child, int last_step) {
  for (const char* name : {"log.txt", "errors.txt"}) fs::remove(child.folder / name);
  const Ended ended = watch_child(child, [](std::string_view) {});
  Told told = told_in(child.folder / "log.txt", last_step);
  told.memory = ended.peak_memory;
  told.fault = ended.fault;
  if (told.fault.empty() && !std::isfinite(told.speed)) told.fault = "did not come to its end";
  if (told.fault.empty() && !std::isfinite(told.kinetic))
    told.fault = "lost its balls: what they do is not a number";
  const std::string said = told.fault.empty() ? "" : complaint(child.folder);
  if (!said.empty()) told.fault += ": " + said;
  return told;
}

}  // namespace

Told by_us(const CrowdRun& run, const fs::path& folder) {
  std::vector<std::string> words = words_for(run);
  words.insert(words.begin(), fs::read_symlink("/proc/self/exe"));
  return told_by({words, folder, {}, patience}, run.lead + run.steps);
}

Told by_peer(Peer peer, const fs::path& folder, int steps, int cores) {
  // Open MPI refuses to serve root, as whom containers commonly run, unless told twice.
  const Child child{
      words_of(peer, steps, cores),
      folder,
      {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
       fmt::format("OMP_NUM_THREADS={}", peer == yade ? cores : 1), fmt::format("STEPS={}", steps)},
      patience};
  return told_by(child, steps);
}

bool is_here(Peer peer, int cores) {
  if (find_program(crowd_programs[peer].command).empty()) return false;
  return cores == 1 || peer == yade || !find_program("mpirun").empty();
}

}  // namespace mahlwerk::bench
