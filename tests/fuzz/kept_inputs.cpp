// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// What the fuzzers have kept, read again by a program of any compiler:
//     fuzz_kept_inputs
// Each input is read or refused within a time; each seed is read.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <exception>

#include "targets.hpp"

namespace {

namespace fs = std::filesystem;
using namespace mahlwerk::fuzz;

constexpr double patience = 10;  // [s] for one input

struct Count {
  int read = 0, refused = 0, faults = 0;
};

void fault(Count& count, const Target& target, const std::string& name, const std::string& what) {
  ++count.faults;
  fmt::print("{}, {}: {}\n", target.name, name, what);
}

void read(Count& count, const Target& target, const std::string& name, const std::string& bytes,
          bool seed) {
  const auto began = std::chrono::steady_clock::now();
  try {
    const std::string why = refusal(target, bytes);
    ++(why.empty() ? count.read : count.refused);
    if (seed && !why.empty()) fault(count, target, name, "is refused: " + why);
  } catch (const std::exception& e) {
    fault(count, target, name, fmt::format("ends with \"{}\"", e.what()));
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - began;
  if (took.count() > patience)
    fault(count, target, name, fmt::format("takes {:.1f} s", took.count()));
}

/// The fuzzers that ctest runs must be those of all targets.
int unknown_to_ctest() {
  std::string names;
  for (const Target& target : targets())
    names += fmt::format("{}{}", names.empty() ? "" : " ", target.name);
  if (names == MAHLWERK_FUZZED) return 0;
  fmt::print("tests/CMakeLists.txt has the fuzzers {}\nbut there are the targets {}\n",
             MAHLWERK_FUZZED, names);
  return 1;
}

int faults_of_all() {
  int faults = unknown_to_ctest();
  for (const Target& target : targets()) {
    Count count;
    int number = 0;
    for (const std::string& seed : target.seeds())
      read(count, target, fmt::format("seed {}", ++number), seed, true);
    if (number == 0) fault(count, target, "seeds", "there are none");
    const fs::path folder = home() / "tests/fuzz/corpus" / target.name;
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder)) files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files)
      read(count, target, file.filename().string(), contents(file), false);
    if (files.empty()) fault(count, target, folder.string(), "nothing is kept");
    fmt::print("{}: {} inputs read, {} refused\n", target.name, count.read, count.refused);
    faults += count.faults;
  }
  return faults;
}

}  // namespace

int main() {
  return faults_of_all() == 0 ? 0 : 1;
}
