// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "render.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <string>
#include <string_view>
#include <utility>

extern char** environ;

namespace mahlwerk::app {
namespace {

namespace fs = std::filesystem;

/// How a program ended: its exit status and what it wrote to stderr; or why it did not start.
struct ProgramEnd {
  int start_error = 0;  // errno
  int status = -1;
  std::string errors;
};

/// Environment of the child: that of this process, with a fixed date for the PDF files, so that
/// equal figures are equal files.
std::vector<char*> child_environment(std::string& date) {
  std::vector<char*> list;
  for (char** one = environ; *one != nullptr; ++one)
    if (std::strncmp(*one, "SOURCE_DATE_EPOCH=", 18) != 0) list.push_back(*one);
  list.push_back(date.data());
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

/// Runs a program of the search path without a shell.
ProgramEnd run_program(std::vector<std::string> words) {
  ProgramEnd end;
  std::array<int, 2> pipe{};
  if (::pipe2(pipe.data(), O_CLOEXEC) != 0)
    return {.start_error = errno, .status = -1, .errors = ""};
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  std::string date = "SOURCE_DATE_EPOCH=0";
  std::vector<char*> environment = child_environment(date);
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

}  // namespace

std::optional<Fault> render_figures(const std::vector<fs::path>& svg_files) {
  constexpr double zoom = 300.0 / 96;  // px per inch of the PNG over those of SVG
  constexpr const char* code = "figures-not-converted";
  for (const fs::path& svg : svg_files)
    for (const std::string format : {"pdf", "png"}) {
      const fs::path file = fs::path(svg).replace_extension(format);
      std::vector<std::string> words{"rsvg-convert", "--format", format, "--output", file.string()};
      if (format == "png") words.insert(words.end(), {"--zoom", fmt::format("{}", zoom)});
      words.push_back(svg.string());
      const ProgramEnd end = run_program(std::move(words));
      if (end.start_error == ENOENT)
        return Fault{"figures", "there are no PDF and PNG files: rsvg-convert is not installed",
                     "install it (apt install librsvg2-bin) and run the command again with --force",
                     code};
      if (end.start_error == 0 && end.status == 0) continue;
      std::error_code ignored;
      fs::remove(file, ignored);
      const std::string why = end.start_error != 0 ? std::string(std::strerror(end.start_error))
                                                   : end.errors.substr(0, end.errors.find('\n'));
      return Fault{"figures/" + file.filename().string(),
                   fmt::format("rsvg-convert failed{}{}; PDF and PNG files are missing",
                               why.empty() ? "" : ": ", why),
                   "convert the SVG files with another program", code};
    }
  return std::nullopt;
}

}  // namespace mahlwerk::app
