// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "commands.hpp"
#include "mahlwerk/cases/keys.hpp"
#include "output.hpp"

namespace mahlwerk::app {
namespace {

/// What stands after a command that is no option, where that is no file: words, or a command of the
/// shell that prints them.
std::string_view arguments(Takes takes) {
  switch (takes) {
    case Takes::room:
      return "mills jars materials media ";
    case Takes::name:
      return "$(\"${COMP_WORDS[0]}\" list 2>/dev/null | awk '/^  / {print $1}') ";
    case Takes::shell:
      return "bash zsh ";
    default:
      return "";
  }
}

const Command* command_called(const std::string& path) {
  const auto is = [&](const Command& c) {
    return path == (c.of.empty() ? "" : std::string(c.of) + " ") + std::string(c.name);
  };
  const auto found = std::ranges::find_if(commands, is);
  return found == commands.end() ? nullptr : &*found;
}

/// A branch of the script: what may stand after one command.
std::string branch(const CommandWords& of) {
  const Command* command = command_called(of.command);
  const std::string_view said = command == nullptr ? "test bench " : arguments(command->takes);
  const bool files = command != nullptr && said.empty();
  return fmt::format("    '{}') words=\"{}{}\"{} ;;\n", of.command, said, fmt::join(of.words, " "),
                     files ? " files=yes" : "");
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
  if [[ ${COMP_WORDS[COMP_CWORD - 1]} == --set ]]; then
    words="@KEYS@" files=''
    compopt -o nospace 2>/dev/null
  fi
  COMPREPLY=($(compgen -W "$words" -- "$cur"))
  [[ $files && $cur != -* ]] && COMPREPLY+=($(compgen -f -- "$cur"))
  return 0
}
complete -o filenames -F _mahlwerk mahlwerk ./mahlwerk
)";
constexpr std::string_view zsh =
    "# mahlwerk completion for zsh: source <(mahlwerk completion zsh)\n"
    "autoload -U +X compinit && compinit -u\nautoload -U +X bashcompinit && bashcompinit\n";

}  // namespace

int completion(const Request& request) {
  std::string parts = " ";  // " sweep status, sweep export,"
  for (const Command& command : commands)
    if (!command.of.empty()) parts += fmt::format("{} {}, ", command.of, command.name);
  std::string script(head), keys;
  for (const CommandWords& one : request.commands) script += branch(one);
  script += tail;
  for (const cases::KeyInfo& key : cases::all_keys()) keys += key.key + "= ";
  script.replace(script.find("@PARTS@"), 7, parts);
  script.replace(script.find("@KEYS@"), 6, keys);
  to_stdout((request.target == "zsh" ? std::string(zsh) : "") + script);
  return fine;
}

}  // namespace mahlwerk::app
