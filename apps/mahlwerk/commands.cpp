// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The list of commands, and options that several commands share.
#include <fmt/format.h>

#include "command.hpp"

namespace mahlwerk::app {

Command run_command(), sweep_command(), compare_command(), fit_command(), optimise_command(),
    match_command(), surrogate_command(), ask_command(), papers_command(), check_command(),
    new_command(), list_command(), describe_command(), completion_command(), manual_command();

std::vector<Command> commands() {
  return {run_command(),      sweep_command(),      compare_command(),   fit_command(),
          optimise_command(), match_command(),      surrogate_command(), ask_command(),
          papers_command(),   check_command(),      new_command(),       list_command(),
          describe_command(), completion_command(), manual_command()};
}

Option one_case() {
  return {.name = "CASE",
          .target = &Request::target,
          .about = "a case file, or a folder with one case",
          .required = true};
}

Option several_cases() {
  return {.name = "CASE",
          .target = &Request::target,
          .about = "a case file, or a folder with a case.toml or with several cases",
          .required = true};
}

Options changes() {
  return {
      {"--set", &Request::set,
       "set one value of the case: --set mill.frequency=\"12 Hz\"; may be repeated", "KEY=VALUE"},
      {"--seed", &Request::seed, "seed of the random numbers; replaces that of the case"}};
}

Options running(std::string_view suffix) {
  return {{.name = "--out",
           .target = &Request::out,
           .about = fmt::format(
               "folder for the results (default: results/ and the name of the case{})", suffix)},
          {"--force", &Request::force, "replace existing results"},
          threads(),
          quiet()};
}

Option threads() {
  return {.name = "--jobs,--threads",
          .target = &Request::threads,
          .about = "number of threads, each for a replicate (default: all cores)",
          .range = {1, 4096}};
}

Option quiet() {
  return {"--quiet", &Request::quiet, "print errors only: no progress, no table"};
}

Option json() {
  return {"--json", &Request::json, "print JSON instead of a table"};
}

Option checkpoint(std::string_view about) {
  return {.name = "--checkpoint",
          .target = &Request::checkpoint,
          .about = std::string(about),
          .type = "SECONDS"};
}

Option resumable_checkpoint() {
  return checkpoint(
      "seconds between two checkpoints of the runs, from which the same command resumes (default "
      "1)");
}

Options joined(std::initializer_list<Options> lists) {
  Options all;
  for (const Options& list : lists) all.insert(all.end(), list.begin(), list.end());
  return all;
}

}  // namespace mahlwerk::app
