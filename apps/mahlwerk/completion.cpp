// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdio>
#include <string>

#include "commands.hpp"

namespace mahlwerk::app {
namespace {

std::string command_words() {
  std::string words;
  for (const Command& command : commands) words += std::string(command.name) + " ";
  return words;
}

constexpr const char* bash = R"(# mahlwerk completion for bash: source <(mahlwerk completion bash)
_mahlwerk() {
  local cur=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]} words=''
  if [[ $COMP_CWORD -eq 1 ]]; then
    words='@WORDS@test bench --help --version'
  elif [[ ($command == run || $command == compare || $command == fit) && $cur == -* ]]; then
    words='--set --seed --out --force --threads --quiet --json --help'
  elif [[ $command == check && $cur == -* ]]; then
    words='--set --seed --json --help'
  elif [[ $command == run || $command == compare || $command == fit || $command == check ]]; then
    COMPREPLY=($(compgen -f -- "$cur"))
    return
  elif [[ $command == list ]]; then
    words='mills jars materials media --json --help'
  elif [[ $command == describe ]]; then
    words=$("${COMP_WORDS[0]}" list 2>/dev/null | awk '/^  / {print $1}')
  elif [[ $command == completion ]]; then
    words='bash zsh'
  fi
  COMPREPLY=($(compgen -W "$words" -- "$cur"))
}
complete -o filenames -F _mahlwerk mahlwerk ./mahlwerk
)";

}  // namespace

int completion(const Request& request) {
  std::string script = bash;
  script.replace(script.find("@WORDS@"), 7, command_words());
  if (request.target == "zsh")
    script =
        "# mahlwerk completion for zsh: source <(mahlwerk completion zsh)\n"
        "autoload -U +X compinit && compinit -u\nautoload -U +X bashcompinit && bashcompinit\n" +
        script;
  std::fputs(script.c_str(), stdout);
  return fine;
}

}  // namespace mahlwerk::app
