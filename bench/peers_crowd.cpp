// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Comparison with LAMMPS, LIGGGHTS and YADE for many balls: drums of 10 000 and 100 000 spheres,
// and five balls among 20 000 grains in a planetary mill. All codes continue from one state in
// motion, in turns, each in its own process, on one core and on two.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>
#include <stdexcept>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "child.hpp"
#include "crowd_files.hpp"
#include "crowd_programs.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int turns = 5;

void say(const std::string& text) {
  fmt::print(stderr, "crowd: {}\n", text);
}

/// Results of one code in its turns.
struct Series {
  std::string code;
  int steps = 0;
  std::vector<double> speeds{}, memories{};
  double kinetic = 0;
  bool failed = false;

  void add(const ProgramResult& told) {
    failed = !told.fault.empty();
    if (failed) return say(fmt::format("{} {}", code, told.fault));
    speeds.push_back(told.speed);
    memories.push_back(told.memory);
    kinetic = told.kinetic;
  }
};

CrowdRun measured(const CrowdCase& c, int steps, int threads) {
  return {.name = c.name, .threads = threads, .steps = steps, .from = "balls.bin"};
}

/// Runs all codes in turns, Mahlwerk first. A code that fails is not run again.
std::vector<Series> take_turns(const CrowdCase& c, const std::filesystem::path& folder, int cores) {
  std::vector<Series> all{{.code = "mahlwerk", .steps = c.steps}};
  for (int i = 0; i < peers; ++i)
    all.push_back({.code = std::string(crowd_programs[i].name),
                   .steps = c.peer_steps[i],
                   .failed = !is_installed(static_cast<Peer>(i), cores)});
  for (int turn = 0; turn < turns; ++turn) {
    say(fmt::format("{}, {} core(s), turn {} of {}", c.what, cores, turn + 1, turns));
    all[0].add(run_mahlwerk(measured(c, c.steps, cores), folder));
    for (int i = 0; i < peers; ++i)
      if (Series& one = all[i + 1]; !one.failed)
        one.add(run_peer(static_cast<Peer>(i), folder, one.steps, cores));
  }
  return all;
}

void add_speeds(std::vector<Row>& rows, const std::string& what, const std::vector<Series>& all,
                const std::string& unit) {
  const auto row = [&](const Series& one, const std::string& metric,
                       const std::vector<double>& values) {
    if (values.empty()) return;
    const auto [least, most] = std::ranges::minmax(values);
    rows.push_back({"crowd", what, one.code, metric + unit, median(values), least, most});
  };
  const Series& ours = all.front();
  for (const Series& one : all) row(one, "particle_steps_per_second", one.speeds);
  for (const Series& one : all) {
    if (&one == &ours) continue;
    std::vector<double> ratios;  // of each turn
    for (std::size_t i = 0; i < std::min(ours.speeds.size(), one.speeds.size()); ++i)
      ratios.push_back(ours.speeds[i] / one.speeds[i]);
    row(ours, "times_as_fast_as_" + one.code, ratios);
  }
  for (const Series& one : all) row(one, "peak_memory_MB", one.memories);
}

/// Kinetic energy at the end of each code's steps, and its ratio to that of Mahlwerk after as many
/// steps.
void add_energies(std::vector<Row>& rows, const CrowdCase& c, const std::vector<Series>& all,
                  const std::filesystem::path& folder) {
  for (const Series& one : all) {
    if (one.speeds.empty()) continue;
    rows.push_back({"crowd", c.what, one.code, "kinetic_energy_J", one.kinetic});
    if (&one == &all.front()) continue;
    const ProgramResult ours = run_mahlwerk(measured(c, one.steps, 2), folder);
    if (ours.fault.empty())
      rows.push_back(
          {"crowd", c.what, one.code, "kinetic_energy_over_mahlwerk", one.kinetic / ours.kinetic});
  }
}

/// Runs from the case's filling to a state in motion, which the other codes have at their time 0:
/// the mill is then where it was at the start.
void warm_up(const CrowdCase& c, const std::filesystem::path& folder) {
  say(c.what + ", warming up");
  const ProgramResult told = run_mahlwerk({.name = c.name,
                                           .threads = 2,
                                           .steps = c.warm_up,
                                           .start = -c.warm_up * c.step,
                                           .to = "balls.bin"},
                                          folder);
  if (!told.fault.empty()) throw std::runtime_error("mahlwerk " + told.fault);
  write_crowd(folder, c, read_balls(folder / "balls.bin"));
}

void add(std::vector<Row>& rows, const CrowdCase& c) {
  const TemporaryFolder folder;
  warm_up(c, folder.path());
  const std::vector<Series> one = take_turns(c, folder.path(), 1);
  add_speeds(rows, c.what, one, "");
  add_energies(rows, c, one, folder.path());
  add_speeds(rows, c.what, take_turns(c, folder.path(), 2), "_two_cores");
}

void tell_absent() {
  for (const CrowdProgram& one : crowd_programs)
    if (find_program(one.command).empty())
      say(fmt::format("{} is left out, it is not installed (Debian: apt-get install {})", one.name,
                      one.package));
}

}  // namespace

std::vector<Row> crowd() {
  std::vector<Row> rows;
  tell_absent();
  try {
    for (const CrowdCase& c : {drum(10000), powder(), drum(100000)}) add(rows, c);
  } catch (const Interrupted& by) {
    std::raise(by.signal);  // nothing is left to tidy up
  } catch (const std::exception& fault) {
    say(fault.what());
  }
  return rows;
}

}  // namespace mahlwerk::bench
