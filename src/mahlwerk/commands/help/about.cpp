// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/help/about.hpp"

#include <filesystem>
#include <system_error>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/error.hpp"

namespace mahlwerk::commands {

std::string_view purpose() {
  return "Mahlwerk simulates ball mills: it takes a mill, a jar and balls, and computes what their "
         "collisions do.";
}

std::string first_example() {
  const std::filesystem::path name = std::filesystem::path("examples") / "01-one-ball";
  std::error_code failed;
  if (std::filesystem::exists(name, failed)) return name.string();
  try {
    return (data_folder("examples") / name.filename()).string();
  } catch (const InputError&) {  // the help is shown without data, too
    return name.string();
  }
}

const std::vector<Explained>& exit_codes() {
  static const std::vector<Explained> codes{{"0", "success"},     {"1", "internal error"},
                                            {"2", "bad input"},   {"3", "a run stopped by physics"},
                                            {"4", "output lost"}, {"130", "interrupted"}};
  return codes;
}

const std::vector<Explained>& environment_variables() {
  static const std::vector<Explained> variables{
      {"MAHLWERK_CATALOGUE", "folder of another catalogue"},
      {"MAHLWERK_SIMD",
       "registers to use: avx512, avx2 or plain (default: the widest of the machine); no result "
       "depends on it"},
      {"MAHLWERK_PROGRESS_EVERY",
       "seconds between two lines of progress where there is no terminal (default: 30)"}};
  return variables;
}

}  // namespace mahlwerk::commands
