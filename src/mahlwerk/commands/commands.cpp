// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/command.hpp"

namespace mahlwerk::commands {

Command run_command(), bond_test_command(), estimate_command(), measure_command(), sweep_command(),
    compare_command(), fit_command(), optimise_command(), match_command(), surrogate_command(),
    ask_command(), papers_command(), report_command(), cite_command(), export_command(),
    check_command(), new_command(), list_command(), describe_command(), completion_command(),
    manual_command(), help_command();

std::vector<Command> all_commands() {
  return {run_command(),       estimate_command(),  measure_command(),  sweep_command(),
          compare_command(),   fit_command(),       optimise_command(), match_command(),
          bond_test_command(), surrogate_command(), ask_command(),      papers_command(),
          report_command(),    cite_command(),      export_command(),   check_command(),
          new_command(),       list_command(),      describe_command(), completion_command(),
          manual_command(),    help_command()};
}

}  // namespace mahlwerk::commands
