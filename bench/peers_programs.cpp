// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "peers_programs.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "child.hpp"
#include "peers_case.hpp"

namespace mahlwerk::bench {
namespace {

namespace fs = std::filesystem;

constexpr int never = 1000000000;  // [steps]

Child child_for(const Program& program, const fs::path& folder, int steps, int every) {
  const std::string deck = fmt::format("{}/bench/peers/{}", MAHLWERK_HOME, program.deck);
  const std::string count = fmt::format("{}", steps), often = fmt::format("{}", every);
  // Open MPI refuses to run as root, the usual user in containers, unless both variables allow it.
  Child child{{},
              folder,
              {"OMP_NUM_THREADS=1", "OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1",
               "STEPS=" + count, "EVERY=" + often},
              every == never ? 120.0 : 900.0};
  const std::string command(program.command);
  if (command == "yade")
    child.words = {command, "-j1", "-n", "-x", deck};
  else
    child.words = {command,   "-in",     deck,         "-log",
                   "log.txt", "-screen", "screen.txt", "-var",
                   "steps",   count,     "-var",       "every",
                   often,     "-var",    "numbers",    std::string(program.numbers)};
  return child;
}

/// Runs the program in a folder of its own, where it writes the balls every `every` steps. Returns
/// its CPU time [s].
Expected<double> run(const Program& program, const Start& start, int steps, int every,
                     const std::function<void(std::string_view)>& line) {
  const TemporaryFolder folder;
  write_case(folder.path() / "case.in", start);
  write_vial(folder.path() / "vial.stl");
  const ChildResult ended = watch_child(child_for(program, folder.path(), steps, every), line);
  if (ended.fault.empty()) return {ended.cpu_seconds, {}};
  const std::string said = complaint(folder.path());
  return {NAN, said.empty() ? ended.fault : ended.fault + ": " + said};
}

}  // namespace

Expected<double> speed_of(const Program& program, const Start& start) {
  const auto silent = [](std::string_view) {};
  const int few = program.steps / 10;
  const Expected<double> brief = run(program, start, few, never, silent);
  if (!brief.fault.empty()) return brief;
  const Expected<double> taken = run(program, start, program.steps, never, silent);
  if (!taken.fault.empty()) return taken;
  if (!(taken.value > brief.value)) return {NAN, "took no longer for ten times as many steps"};
  const double particle_steps = static_cast<double>(start.size()) * (program.steps - few);
  return {particle_steps / (taken.value - brief.value), {}};
}

Expected<Physics> physics_of(const Program& program, const Start& start) {
  constexpr const PlanetaryCase& c = planetary_case;
  Analysis analysis(c.from, c.to);
  DumpReader reader(static_cast<int>(start.size()), c.step, analysis);
  const auto steps = static_cast<int>(std::lround(c.to / c.step));
  const auto every = static_cast<int>(std::lround(c.between_samples / c.step));
  const Expected<double> taken =
      run(program, start, steps, every, [&](std::string_view line) { reader.line(line); });
  if (!taken.fault.empty()) return {{}, taken.fault};
  const Physics physics = analysis.physics();
  if (!(analysis.last_sample_time() > c.to - c.between_samples / 2))
    return {{}, fmt::format("gave samples only up to {} s", analysis.last_sample_time())};
  if (!std::isfinite(physics.power) || !std::isfinite(physics.kinetic))
    return {{}, "lost its balls: their energy is not a number"};
  return {physics, {}};
}

}  // namespace mahlwerk::bench
