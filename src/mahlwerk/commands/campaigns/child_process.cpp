// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/campaigns/child_process.hpp"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <memory>
#include <string_view>

extern char** environ;

namespace mahlwerk::commands {
namespace {

/// Environment of the child: that of this process with one more or another variable.
std::vector<char*> child_environment(std::string& variable) {
  const std::string name = variable.substr(0, variable.find('=') + 1);
  std::vector<char*> list;
  for (char** one = environ; *one != nullptr; ++one)
    if (!std::string_view(*one).starts_with(name)) list.push_back(*one);
  list.push_back(variable.data());
  list.push_back(nullptr);
  return list;
}

std::string read_all(int from) {
  std::string text;
  std::array<char, 1024> block{};
  for (;;) {
    const ssize_t got = ::read(from, block.data(), block.size());
    if (got > 0) text.append(block.data(), static_cast<std::size_t>(got));
    if (got == 0 || (got < 0 && errno != EINTR)) return text;
  }
}

}  // namespace

ProgramEnd run_program(std::vector<std::string> words, std::string variable) {
  ProgramEnd end;
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
    return {.start_error = errno, .status = -1, .errors = ""};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::vector<char*> environment = child_environment(variable);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, pipe[1], STDERR_FILENO);
  ::pid_t child = 0;
  end.start_error =
      ::posix_spawnp(&child, arguments[0], &actions, nullptr, arguments.data(), environment.data());
  posix_spawn_file_actions_destroy(&actions);
  ::close(pipe[1]);
  if (end.start_error == 0) {
    end.errors = read_all(pipe[0]);
    while (::waitpid(child, &end.status, 0) < 0 && errno == EINTR) {
    }
  }
  ::close(pipe[0]);
  return end;
}

CommandOutput shell_output(const std::string& command) {
  struct Close {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
  };
  std::unique_ptr<std::FILE, Close> pipe(popen((command + " 2>&1").c_str(), "r"));
  CommandOutput output;
  for (int c; pipe && (c = std::fgetc(pipe.get())) != EOF;) output.text += static_cast<char>(c);
  const int status = pipe ? pclose(pipe.release()) : -1;
  if (status != -1 && WIFEXITED(status)) output.exit_code = WEXITSTATUS(status);
  return output;
}

}  // namespace mahlwerk::commands
