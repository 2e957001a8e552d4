// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/help/about.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <system_error>

#include "mahlwerk/base/data_folder.hpp"
#include "mahlwerk/base/error.hpp"

namespace mahlwerk::commands {

std::string_view command_completions() {
  return "$(\"${COMP_WORDS[0]}\" --help 2>/dev/null | awk '/^Commands/ {on = 1} on && /^  / "
         "{print $1}')";
}

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

const std::vector<Explained>& general_options() {
  static const std::vector<Explained> options{
      {"-h,--help", "print the help of the program or of a command"},
      {"-V,--version", "print the version, and the registers that it uses"},
      {"--color WHEN", "auto (default: colours on a terminal), always or never"}};
  return options;
}

std::string value_name(const Option& option) {
  if (std::holds_alternative<bool*>(option.target)) return "";
  if (!option.type.empty()) return option.type;
  if (!option.values.empty()) return fmt::format("{}", fmt::join(option.values, "|"));
  if (std::holds_alternative<std::optional<std::filesystem::path>*>(option.target)) return "PATH";
  const bool number = std::holds_alternative<int*>(option.target) ||
                      std::holds_alternative<std::optional<std::uint64_t>*>(option.target);
  return number ? "NUMBER" : "TEXT";
}

std::string meaning_of(const Option& option) {
  std::string about = option.about;
  if (option.range[1] > 0) about += fmt::format("; {} to {}", option.range[0], option.range[1]);
  if (!option.needs.empty()) about += "; needs " + option.needs;
  if (!option.excludes.empty()) about += "; not with " + option.excludes;
  return about;
}

const std::vector<Explained>& environment_variables() {
  static const std::vector<Explained> variables{
      {"MAHLWERK_CATALOGUE", "folder of another catalogue"},
      {"MAHLWERK_SIMD",
       "registers to use: avx512, avx2 or plain (default: the widest of the machine); no result "
       "depends on it"},
      {"MAHLWERK_PROGRESS_EVERY",
       "seconds between two lines of progress where there is no terminal (default: 30)"},
      {"NO_COLOR", "if not empty, no colours; --color always overrides it"},
      {"COLUMNS", "width of the terminal in characters (default: that of its window)"}};
  return variables;
}

}  // namespace mahlwerk::commands
