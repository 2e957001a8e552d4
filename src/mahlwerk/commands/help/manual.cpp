// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// manual: manual pages of the program and of its commands (roff), from the descriptions of the
// commands.
#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/help/about.hpp"
#include "mahlwerk/commands/help/find_command.hpp"
#include "mahlwerk/commands/places.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"

namespace mahlwerk::commands {
namespace {

/// `text` as roff shows it: hyphens that can be copied, no control lines, no escapes.
std::string roff(std::string_view text) {
  std::string made;
  for (const char c : text)
    made += c == '\\' ? "\\e" : c == '-' ? "\\-" : c == '\'' ? "\\(aq" : std::string(1, c);
  return made.starts_with(".") ? "\\&" + made : made;
}

std::string upper(std::string text) {
  for (char& c : text)
    if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
  return text;
}

std::string header(const std::string& page, std::string_view about) {
  return fmt::format(".TH \"{}\" 1 \"\" \"Mahlwerk {}\" \"Mahlwerk\"\n.SH NAME\n{} \\- {}\n",
                     roff(upper(page)), roff(version()), roff(page), roff(about));
}

/// A tagged paragraph; `tag` is roff, `text` is not.
std::string tagged(const std::string& tag, std::string_view text) {
  return fmt::format(".TP\n{}\n{}\n", tag, roff(text));
}

std::string described(const Option& option) {
  if (!option.name.starts_with("-"))
    return tagged(fmt::format("\\fI{}\\fR", roff(option.name)), option.about);
  std::string tag, name = option.name;
  for (std::size_t comma; (comma = name.find(',')) != std::string::npos;) {
    tag += fmt::format("\\fB{}\\fR, ", roff(name.substr(0, comma)));
    name.erase(0, comma + 1);
  }
  tag += fmt::format("\\fB{}\\fR", roff(name));
  if (const std::string value = value_name(option); !value.empty())
    tag += fmt::format(" \\fI{}\\fR", roff(value));
  return tagged(tag, meaning_of(option));
}

std::string synopsis(const std::string& path, const Command& command) {
  std::string line = fmt::format("\\fBmahlwerk {}\\fR", roff(path));
  const auto is_option = [](const Option& one) { return one.name.starts_with("-"); };
  if (std::ranges::any_of(command.options, is_option)) line += " [\\fIOPTION\\fR ...]";
  for (const Option& one : command.options)
    if (!is_option(one))
      line += fmt::format(" {}\\fI{}\\fR{}", one.required ? "" : "[", roff(one.name),
                          one.required ? "" : "]");
  return line + "\n";
}

std::string described_options(const Command& command) {
  std::string text;
  for (const Option& one : command.options) text += described(one);
  return text;
}

std::string list_of(const char* title, const std::vector<Explained>& words) {
  std::string text = fmt::format(".SH \"{}\"\n", title);
  for (const Explained& one : words)
    text += tagged(fmt::format("\\fB{}\\fR", roff(one.word)), one.meaning);
  return text;
}

/// The end of every page: exit codes, environment, other pages.
std::string ending(const std::vector<std::string>& pages) {
  std::vector<std::string> others;
  for (const std::string& page : pages) others.push_back(fmt::format("\\fB{}\\fR(1)", roff(page)));
  return list_of("EXIT STATUS", exit_codes()) + list_of("ENVIRONMENT", environment_variables()) +
         fmt::format(".SH \"SEE ALSO\"\n{}\n", fmt::join(others, ",\n"));
}

std::string page_name(const Command& command) {
  return "mahlwerk-" + command.name;
}

std::string program_page(const std::vector<Command>& all) {
  std::string text =
      header("mahlwerk", "simulator of ball mills") +
      ".SH SYNOPSIS\n\\fBmahlwerk\\fR \\fICOMMAND\\fR [\\fIOPTION\\fR ...] [\\fICASE\\fR]\n.br\n"
      "\\fBmahlwerk\\fR [\\fICOMMAND\\fR] \\fB\\-\\-help\\fR\n.br\n"
      "\\fBmahlwerk\\fR \\fB\\-\\-version\\fR\n.SH DESCRIPTION\n" +
      roff(purpose()) + "\n.SH OPTIONS\n";
  for (const Explained& option : general_options())
    text += tagged(fmt::format("\\fB{}\\fR", roff(option.word)), option.meaning);
  text += ".SH COMMANDS\n";
  std::vector<std::string> pages;
  for (const Command& command : all) {
    text += tagged(fmt::format("\\fB{}\\fR", roff(command.name)), command.about);
    pages.push_back(page_name(command));
  }
  text += ".SH FILES\nRelative to the folder above that of the program:\n" +
          tagged("\\fIshare/mahlwerk\\fR",
                 "catalogue, papers, validation, and examples, of which mahlwerk --help names the "
                 "first") +
          tagged("\\fIshare/doc/mahlwerk/docs\\fR", "the documents that messages name");
  return text + ending(pages);
}

std::string command_page(const Command& command) {
  std::string text = header(page_name(command), command.about) + ".SH SYNOPSIS\n" +
                     synopsis(command.name, command);
  for (const Command& part : command.subcommands)
    text += ".br\n" + synopsis(command.name + " " + part.name, part);
  text += ".SH OPTIONS\n" + described_options(command);
  for (const Command& part : command.subcommands)
    text += fmt::format(".SH \"{} {}\"\n{}\n", upper(command.name), upper(part.name),
                        roff(part.about)) +
            described_options(part);
  return text + ending({"mahlwerk"});
}

int manual(const std::string& name) {
  const std::vector<Command> all = all_commands();
  verbatim_to_stdout(name.empty() ? program_page(all) : command_page(find_command(all, {name})));
  return success;
}

}  // namespace

Command manual_command() {
  const auto name = std::make_shared<std::string>();
  return {
      "manual",
      "print a manual page (roff) of the program or of a command: mahlwerk manual run | man -l -",
      {{.name = "COMMAND",
        .target = name.get(),
        .about = "a command (default: the program)",
        .completions = std::string(command_completions())}},
      [name] { return manual(*name); }};
}

}  // namespace mahlwerk::commands
