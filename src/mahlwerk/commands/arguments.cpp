// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/arguments.hpp"

#include <fmt/format.h>

namespace mahlwerk::commands {

std::vector<cases::Override> Changes::overrides() const {
  std::vector<cases::Override> all;
  for (const std::string& key : unset) all.push_back({.key = key, .value = "", .unset = true});
  all.insert(all.end(), set.begin(), set.end());
  if (seed) all.push_back({"seed", std::to_string(*seed)});
  return all;
}

Option one_case(std::string& target) {
  return {.name = "CASE",
          .target = &target,
          .about = "a case file, or a folder with one case",
          .required = true};
}

Option several_cases(std::string& target) {
  return {.name = "CASE",
          .target = &target,
          .about = "a case file, or a folder with a case.toml or with several cases",
          .required = true};
}

Options options_of(Changes& changes) {
  return {
      {"--set", &changes.set,
       "set one value of the case: --set mill.frequency=\"12 Hz\"; may be repeated", "KEY=VALUE"},
      {"--unset", &changes.unset,
       "take one value, or a whole section, from the case: --unset powder.mass; may be repeated",
       "KEY"},
      {"--seed", &changes.seed, "seed of the random numbers; replaces that of the case"}};
}

Options options_of(Running& running, std::string_view suffix) {
  return {{.name = "--out",
           .target = &running.out,
           .about = fmt::format(
               "folder for the results (default: results/ and the name of the case{})", suffix)},
          {"--force", &running.force, "replace existing results"},
          threads(running.threads),
          quiet(running.quiet)};
}

Option threads(int& count) {
  return {.name = "--jobs,--threads",
          .target = &count,
          .about = "number of threads, each for a replicate (default: all cores)",
          .range = {1, 4096}};
}

Option quiet(bool& flag) {
  return {"--quiet", &flag, "print errors only: no progress, no table"};
}

Option json(bool& flag) {
  return {"--json", &flag, "print JSON instead of a table"};
}

Option checkpoint(std::optional<double>& interval, std::string_view about) {
  return {
      .name = "--checkpoint", .target = &interval, .about = std::string(about), .type = "SECONDS"};
}

Option resumable_checkpoint(std::optional<double>& interval) {
  return checkpoint(interval,
                    "seconds between two checkpoints of the runs, from which the same command "
                    "resumes (default 1)");
}

Options joined(std::initializer_list<Options> lists) {
  Options all;
  for (const Options& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace mahlwerk::commands
