// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// In place of src/mahlwerk/lammps/program.cpp: a page starts no program, and refuses such cases
// before (page_limits.cpp).
#include "mahlwerk/lammps/program.hpp"

namespace mahlwerk::lammps {

Installed installed(int) {
  return {.command = "",
          .version = "",
          .faults = {{"run.engine", "a page cannot start LAMMPS",
                      "compute this case with the program", "lammps"}}};
}

Running::Running(const std::filesystem::path&, const std::vector<std::string>&) {
  throw RunError("a page cannot start LAMMPS");
}
bool Running::ended() {
  return child_ < 0;
}
void Running::stop() {}
void wait_for_others(const std::filesystem::path&) {}

std::string last_error(const std::filesystem::path&) {
  return "";
}

}  // namespace mahlwerk::lammps
