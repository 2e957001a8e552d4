// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "page_limits.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <string>
#include <string_view>

#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/faults.hpp"

namespace mahlwerk::web {

std::vector<Fault> page_faults(const cases::Case& mill_case) {
  constexpr std::int64_t most_balls = 100'000, most_replicates = 1000;
  std::vector<Fault> found;
  const auto limit = [&](std::string_view key, std::int64_t given, std::int64_t most,
                         std::string_view what) {
    if (given > most)
      found.push_back(
          {cases::location_of(mill_case, std::string(key)),
           fmt::format("the page computes at most {} {}, here are {}", most, what, given),
           "compute this case with the program", ""});
  };
  if (mill_case.run.engine == cases::EngineName::lammps)
    found.push_back({cases::location_of(mill_case, "run.engine"),
                     "LAMMPS is a program of its own, which a page cannot start",
                     "write engine = \"soft\", or compute this case with the program", "lammps"});
  limit("balls.1.count", cases::balls_count(mill_case.balls), most_balls, "balls");
  limit("run.replicates", mill_case.run.replicates, most_replicates, "replicates");
  return found;
}

Notices left_to_program(const cases::Case& mill_case) {
  std::string names;
  const auto add = [&](bool there, std::string_view name) {
    if (there) names += fmt::format("{}{}", names.empty() ? "" : ", ", name);
  };
  add(!mill_case.sweep.empty(), "[sweep]");
  add(mill_case.optimise.has_value(), "[optimise]");
  add(mill_case.match.has_value(), "[match]");
  add(!mill_case.fit.empty(), "[fit]");
  add(mill_case.run.sensitivity == cases::SensitivityMode::on, "run.sensitivity");
  if (names.empty()) return {};
  names +=
      " is left to the program: the page computes one setting, or varies a key in the tab Sweep.";
  return {{"", Severity::warning, names}};
}

}  // namespace mahlwerk::web
