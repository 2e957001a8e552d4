// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/command.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::commands::command_test {
namespace {

/// The commands with their subcommands.
std::vector<Command> flat(const std::vector<Command>& commands) {
  std::vector<Command> all = commands;
  for (const Command& command : commands)
    all.insert(all.end(), command.subcommands.begin(), command.subcommands.end());
  return all;
}

std::vector<std::string> names_of(const Option& option) {
  std::vector<std::string> names;
  std::stringstream text(option.name);
  for (std::string name; std::getline(text, name, ',');) names.push_back(name);
  return names;
}

const void* target_of(const Option& option) {
  return std::visit([](const auto* target) -> const void* { return target; }, option.target);
}

/// Commands of `all` that have an option for which `wrong(options before, option)` holds.
template <class Wrong>
std::string commands_with(const std::vector<Command>& all, const Wrong& wrong) {
  std::string found;
  for (const Command& command : all)
    for (std::size_t i = 0; i < command.options.size(); ++i) {
      const Options before(command.options.begin(),
                           command.options.begin() + static_cast<std::ptrdiff_t>(i));
      if (wrong(before, command.options[i]))
        found += command.name + " " + command.options[i].name + "; ";
    }
  return found;
}

TEST(Command, each_option_has_names_and_a_target_of_its_own) {
  const auto shared = [](const Options& before, const Option& option) {
    return std::ranges::any_of(before, [&](const Option& other) {
      const std::vector<std::string> names = names_of(option), others = names_of(other);
      return target_of(other) == target_of(option) ||
             std::ranges::find_first_of(names, others) != names.end();
    });
  };
  EXPECT_EQ(commands_with(flat(all_commands()), shared), "");
}

TEST(Command, excluded_and_needed_options_are_listed_before) {
  const auto unknown = [](const Options& before, const Option& option) {
    const auto listed = [&](const std::string& name) {
      return name.empty() || std::ranges::find(before, name, &Option::name) != before.end();
    };
    return !listed(option.excludes) || !listed(option.needs);
  };
  EXPECT_EQ(commands_with(flat(all_commands()), unknown), "");
}

TEST(Command, two_calls_share_no_argument) {
  const std::vector<Command> one = flat(all_commands()), other = flat(all_commands());
  std::set<const void*> targets;
  for (const Command& command : one)
    for (const Option& option : command.options) targets.insert(target_of(option));
  EXPECT_GT(targets.size(), one.size());
  for (const Command& command : other)
    for (const Option& option : command.options)
      EXPECT_FALSE(targets.contains(target_of(option))) << command.name << ' ' << option.name;
}

TEST(Command, an_option_sets_the_argument_that_the_command_reads) {
  const std::vector<Command> all = all_commands();
  const Command& check = *std::ranges::find(all, "check", &Command::name);
  *std::get<std::string*>(check.options.front().target) = "no-such-folder";
  std::string where;
  try {
    check.perform();
  } catch (const InputError& error) {
    where = error.faults().front().where;
  }
  EXPECT_EQ(where, "no-such-folder");
}

}  // namespace
}  // namespace mahlwerk::commands::command_test
