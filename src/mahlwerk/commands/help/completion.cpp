// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <string>
#include <vector>

#include "mahlwerk/cases/keys.hpp"
#include "mahlwerk/commands/command.hpp"
#include "mahlwerk/commands/reporting/messages.hpp"

namespace mahlwerk::commands {
namespace {

std::string completions_of(const Option& option) {
  std::string all = option.completions;
  if (option.more_completions != nullptr)
    all += fmt::format("{}{}", all.empty() ? "" : " ", fmt::join(option.more_completions(), " "));
  return all;
}

/// A `case` branch of the script for each command: its subcommands, options and positional
/// arguments. Adds a branch to `values` for each option whose values are known.
std::string branches(const std::string& path, const Command& command, std::string& values) {
  std::vector<std::string> words;
  std::string offers;
  bool files = false;
  for (const Command& part : command.subcommands) words.push_back(part.name);
  words.insert(words.end(), {"--help", "--color"});
  for (const Option& option : command.options) {
    const std::string known = completions_of(option);
    if (!option.name.starts_with("-")) {
      if (!known.empty()) offers += known + " ";
      files = known.empty();
      continue;
    }
    words.push_back(option.name);
    if (!known.empty())
      values += fmt::format("    {}) words=\"{}\" files='' ;;\n", option.name, known);
  }
  for (std::string& word : words)  // "--jobs,--threads" are two
    if (const auto comma = word.find(','); comma != std::string::npos) word[comma] = ' ';
  std::string all = fmt::format("    '{}') words=\"{}{}\"{} ;;\n", path, offers,
                                fmt::join(words, " "), files ? " files=yes" : "");
  for (const Command& part : command.subcommands)
    all += branches(fmt::format("{} {}", path, part.name), part, values);
  return all;
}

constexpr std::string_view head =
    R"(# mahlwerk completion for bash: source <(mahlwerk completion bash)
_mahlwerk() {
  local cur=${COMP_WORDS[COMP_CWORD]} command='' words='' files=''
  [[ $COMP_CWORD -gt 1 ]] && command=${COMP_WORDS[1]}
  [[ $COMP_CWORD -gt 2 && "@PARTS@" == *" $command ${COMP_WORDS[2]},"* ]] && command+=" ${COMP_WORDS[2]}"
  case $command in
)";
constexpr std::string_view tail = R"(  esac
  case ${COMP_WORDS[COMP_CWORD - 1]} in
    --set) words="@KEYS@" files=''; compopt -o nospace 2>/dev/null ;;
    --unset) words="@NAMES@" files='' ;;
    --color) words="auto always never" files='' ;;
@VALUES@  esac
  COMPREPLY=($(compgen -W "$words" -- "$cur"))
  [[ $files && $cur != -* ]] && COMPREPLY+=($(compgen -f -- "$cur"))
  return 0
}
complete -o filenames -F _mahlwerk mahlwerk ./mahlwerk
)";
// The commands test and bench belong to the launcher script of the sources.
constexpr std::string_view launcher = " && [[ ${COMP_WORDS[0]} == ./* ]] && words+=' test bench'";
// For `source`, and for a file _mahlwerk in a folder of $fpath, which zsh runs when it first
// completes.
constexpr std::string_view zsh_head =
    "#compdef mahlwerk\n# mahlwerk completion for zsh: source <(mahlwerk completion zsh)\n"
    "(( $+functions[compdef] )) || { autoload -U +X compinit && compinit -u; }\n"
    "autoload -U +X bashcompinit && bashcompinit\n";
constexpr std::string_view zsh_tail =
    "if [[ ${funcstack[1]} == _mahlwerk ]]; then _bash_complete -o filenames -F _mahlwerk; fi\n";

int completion(const std::string& shell) {
  const std::vector<Command> all = all_commands();
  std::string parts = " ";  // " sweep status, sweep export,"
  std::string names, below, keys, key_names, values;
  for (const Command& command : all) {
    for (const Command& part : command.subcommands)
      parts += fmt::format("{} {}, ", command.name, part.name);
    names += command.name + " ";
    below += branches(command.name, command, values);
  }
  for (const cases::KeyInfo& key : cases::all_keys()) {
    keys += key.key + "= ";
    key_names += key.key + ' ';
  }
  std::string script(head);
  script +=
      fmt::format("    '') words=\"{}--help --version --color\"{} ;;\n", names, launcher) + below;
  script += tail;
  script.replace(script.find("@PARTS@"), 7, parts);
  script.replace(script.find("@KEYS@"), 6, keys);
  script.replace(script.find("@NAMES@"), 7, key_names);
  script.replace(script.find("@VALUES@"), 8, values);
  if (shell == "zsh") script = fmt::format("{}{}{}", zsh_head, script, zsh_tail);
  verbatim_to_stdout(script);
  return success;
}

}  // namespace

Command completion_command() {
  const auto shell = std::make_shared<std::string>();
  return {"completion",
          "print a completion script for your shell: bash or zsh",
          {{.name = "SHELL",
            .target = shell.get(),
            .about = "bash or zsh",
            .required = true,
            .values = {"bash", "zsh"},
            .completions = "bash zsh"}},
          [shell] { return completion(*shell); }};
}

}  // namespace mahlwerk::commands
