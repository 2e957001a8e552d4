// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What a user waits for: the start of the program, `check` and a whole run of every example.
#include <fmt/format.h>

#include <algorithm>
#include <csignal>

#include "benchmarks.hpp"
#include "child.hpp"

namespace mahlwerk::bench {
namespace {

namespace fs = std::filesystem;

constexpr int turns = 5;

/// The wall time of a command that takes a moment.
Row moment(const std::string& what, const char* metric, const std::vector<std::string>& words) {
  std::vector<double> walls;
  const TemporaryFolder folder;
  for (int turn = 0; turn < turns; ++turn)
    walls.push_back(time_mahlwerk(words, folder.path()).wall);
  const auto [least, most] = std::ranges::minmax(walls);
  return {"examples", what, "mahlwerk", metric, median(walls), least, most};
}

void example(std::vector<Row>& rows, const fs::path& place) {
  const std::string name = place.filename();
  const bool campaign = name == "09-campaign";
  fmt::print(stderr, "examples: {}\n", name);
  rows.push_back(moment(name, "check_wall_s", {"check", place}));
  const TemporaryFolder folder;
  const Timing whole =
      time_mahlwerk({campaign ? "sweep" : "run", place, "--out", folder.path() / "out", "--quiet"},
                    folder.path());
  rows.push_back({"examples", name, "mahlwerk", "run_cpu_s", whole.cpu});
  rows.push_back({"examples", name, "mahlwerk", "run_wall_s", whole.wall});
  rows.push_back({"examples", name, "mahlwerk", "peak_memory_MB", whole.memory});
}

}  // namespace

std::vector<Row> whole_examples() {
  std::vector<Row> rows;
  std::vector<fs::path> places;
  for (const fs::directory_entry& one : fs::directory_iterator(MAHLWERK_HOME "/examples"))
    if (fs::exists(one.path() / "case.toml")) places.push_back(one.path());
  std::ranges::sort(places);
  try {
    rows.push_back(moment("start of the program", "wall_s", {"--version"}));
    for (const fs::path& place : places) example(rows, place);
  } catch (const Interrupted& by) {
    std::raise(by.signal);  // nothing is left to tidy up
  }
  return rows;
}

}  // namespace mahlwerk::bench
