// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// CPU time per ball and step on one core, and memory, for the same bed of a drum made of ever
// smaller balls. Every bed has been in motion for the same number of its own time steps before.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <string>
#include <vector>

#include "benchmarks.hpp"
#include "child.hpp"
#include "crowd_programs.hpp"

namespace mahlwerk::bench {
namespace {

constexpr int turns = 3, warm_up_steps = 1000, lead = 50;  // [steps]

void add(std::vector<Row>& rows, int count, int steps) {
  const CrowdCase c = drum(count);
  const TemporaryFolder folder;
  fmt::print(stderr, "cost-curve: {}\n", c.what);
  ProgramResult result = run_mahlwerk(
      {.name = c.name, .threads = 2, .steps = warm_up_steps, .to = "balls.bin"}, folder.path());
  std::vector<double> costs, memories;
  for (int turn = 0; turn < turns && result.fault.empty(); ++turn) {
    result = run_mahlwerk({.name = c.name, .lead = lead, .steps = steps, .from = "balls.bin"},
                          folder.path());
    costs.push_back(1e9 * result.cost);
    memories.push_back(result.memory);
  }
  if (!result.fault.empty()) {
    fmt::print(stderr, "cost-curve: mahlwerk {}\n", result.fault);
    return;
  }
  const auto row = [&](const char* metric, const std::vector<double>& values) {
    const auto [least, most] = std::ranges::minmax(values);
    rows.push_back({"cost-curve", c.what, "mahlwerk", metric, median(values), least, most});
  };
  row("ns_per_particle_step", costs);
  row("peak_memory_MB", memories);
}

}  // namespace

std::vector<Row> cost_curve() {
  std::vector<Row> rows;
  try {
    add(rows, 10000, 2000);
    add(rows, 100000, 300);
    add(rows, 1000000, 60);
  } catch (const Interrupted& by) {
    std::raise(by.signal);  // nothing is left to tidy up
  }
  return rows;
}

}  // namespace mahlwerk::bench
