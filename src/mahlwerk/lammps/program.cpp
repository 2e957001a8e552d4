// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/program.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <memory>
#include <sstream>
#include <string_view>
#include <thread>

namespace mahlwerk::lammps {
namespace fs = std::filesystem;
namespace {

constexpr const char* code = "lammps";

bool on_path(const std::string& program) {
  std::error_code error;
  if (program.find('/') != std::string::npos)
    return ::access(program.c_str(), X_OK) == 0 && fs::is_regular_file(program, error);
  const char* path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((fs::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

/// What `program -help` prints.
std::string help_of(const std::string& program) {
  struct Close {
    void operator()(std::FILE* pipe) const { pclose(pipe); }
  };
  std::string quoted = "'";
  for (const char c : program) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  const std::unique_ptr<std::FILE, Close> pipe(
      popen(("timeout 20 " + quoted + "' -help 2>/dev/null </dev/null").c_str(), "r"));
  std::string text;
  std::array<char, 4096> block{};
  while (pipe)
    if (const std::size_t got = std::fread(block.data(), 1, block.size(), pipe.get()); got > 0)
      text.append(block.data(), got);
    else
      break;
  return text;
}

bool has_word(const std::string& text, const std::string& word) {
  std::istringstream words(text);
  for (std::string one; words >> one;)
    if (one == word) return true;
  return false;
}

/// Year, month and day as one number, which grows with the date of a version: "29 Sep 2021".
int date_of(const std::string& version) {
  constexpr std::array<std::string_view, 12> months{"Jan", "Feb", "Mar", "Apr", "May", "Jun",
                                                    "Jul", "Aug", "Sep", "Oct", "Nov", "Dec"};
  std::istringstream words(version);
  int day = 0, year = 0;
  std::string month;
  if (!(words >> day >> month >> year)) return 0;
  const auto at = std::ranges::find(months, month.substr(0, 3));
  return year * 10000 + static_cast<int>(at - months.begin() + 1) * 100 + day;
}

Fault missing(std::string what, std::string remedy) {
  return {"run.engine = \"lammps\"", std::move(what), std::move(remedy), code};
}

const std::string install =
    "install it (Debian: apt install lammps), or name the program in the "
    "environment variable MAHLWERK_LAMMPS, or give --write-only";

/// The styles of an input script that not every LAMMPS has, with their packages.
std::vector<Fault> missing_styles(const Installed& lmp, const std::string& help) {
  struct Style {
    const char *name, *package;
  };
  constexpr std::array styles{Style{"granular", "GRANULAR"}, Style{"wall/gran/region", "GRANULAR"},
                              Style{"tracker", "MISC"}, Style{"pair/tracker", "MISC"}};
  std::vector<Fault> found;
  constexpr int oldest = 20210929;
  if (date_of(lmp.version) < oldest)
    found.push_back(missing(fmt::format("{} is LAMMPS of {}, older than 29 Sep 2021", lmp.command,
                                        lmp.version.empty() ? "an unknown date" : lmp.version),
                            install));
  for (const Style& style : styles)
    if (!has_word(help, style.name))
      found.push_back(
          missing(fmt::format("{} lacks the style {} of its package {}", lmp.command, style.name,
                              style.package),
                  "take a LAMMPS that was built with the packages GRANULAR and MISC: " + install));
  return found;
}

/// Processes of this machine whose current folder is `folder`.
std::vector<int> at_work_in(const fs::path& folder) {
  std::vector<int> found;
  std::error_code error;
  const fs::path place = fs::canonical(folder, error);
  if (error) return found;
  for (fs::directory_iterator at("/proc", error), end; !error && at != end; at.increment(error)) {
    const std::string name = at->path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::error_code gone;
    const fs::path its = fs::read_symlink(at->path() / "cwd", gone);
    if (gone || its != place) continue;
    const fs::path program = fs::read_symlink(at->path() / "exe", gone).filename();
    if (!gone && program.string().find("lmp") != std::string::npos)
      found.push_back(std::stoi(name));
  }
  return found;
}

}  // namespace

Installed installed(int ranks) {
  Installed lmp;
  const char* named = std::getenv("MAHLWERK_LAMMPS");
  const std::vector<std::string> names = named != nullptr
                                             ? std::vector<std::string>{named}
                                             : std::vector<std::string>{"lmp", "lmp_mpi"};
  for (const std::string& name : names)
    if (lmp.command.empty() && on_path(name)) lmp.command = name;
  if (lmp.command.empty()) {
    lmp.faults.push_back(missing(
        named != nullptr ? fmt::format("MAHLWERK_LAMMPS names {}, which is no program", named)
                         : "LAMMPS is not installed: there is no program lmp or lmp_mpi",
        install));
    return lmp;
  }
  if (lmp.command.find('/') != std::string::npos) lmp.command = fs::absolute(lmp.command).string();
  const std::string help = help_of(lmp.command);
  if (help.empty()) {
    lmp.faults.push_back(missing(lmp.command + " -help prints nothing within 20 s", install));
    return lmp;
  }
  constexpr std::string_view before = "Simulator - ";
  if (const std::size_t at = help.find(before); at != std::string::npos) {
    lmp.version = help.substr(at + before.size(), help.find('\n', at) - at - before.size());
    lmp.version = lmp.version.substr(0, lmp.version.find(" - "));
  }
  lmp.faults = missing_styles(lmp, help);
  if (ranks > 1 && !on_path("mpirun"))
    lmp.faults.push_back(
        missing("there is no program mpirun, which starts several ranks",
                "install it (Debian: apt install openmpi-bin), or give --ranks 1"));
  return lmp;
}

Running::Running(const fs::path& folder, const std::vector<std::string>& given) : folder_(folder) {
  std::vector<std::string> words = given;
  std::vector<char*> arguments;
  for (std::string& word : words) arguments.push_back(word.data());
  arguments.push_back(nullptr);
  const std::string place = folder.string();
  child_ = ::fork();
  if (child_ < 0) throw RunError(fmt::format("LAMMPS cannot be started: {}", std::strerror(errno)));
  if (child_ == 0) {  // only calls that are safe after a fork of several threads
    ::setpgid(0, 0);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    if (::chdir(place.c_str()) != 0) ::_exit(127);
    const int screen = ::open("screen.txt", O_WRONLY | O_CREAT | O_TRUNC, 0644);
    const int nothing = ::open("/dev/null", O_RDONLY);
    ::dup2(nothing, STDIN_FILENO);
    ::dup2(screen, STDOUT_FILENO);
    ::dup2(screen, STDERR_FILENO);
    ::execvp(arguments.front(), arguments.data());
    ::_exit(127);
  }
  ::setpgid(child_, child_);
}

/// Takes over the status of a child that has ended, and the CPU time of it and of its own children.
bool Running::collect(int options) {
  rusage used{};
  if (::wait4(child_, &status_, options, &used) != child_) return false;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  cpu_seconds_ = seconds(used.ru_utime) + seconds(used.ru_stime);
  child_ = -1;
  return true;
}

bool Running::ended() {
  return child_ < 0 || collect(WNOHANG);
}

void Running::stop() {
  if (ended()) return;
  const int group = child_;
  constexpr int patience = 200;  // of 10 ms
  const auto wait_until = [](const auto& done) {
    for (int i = 0; i < patience && !done(); ++i)
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
  };
  ::kill(-group, SIGTERM);
  wait_until([&] { return ended(); });
  ::kill(-group, SIGKILL);  // and what the leader left behind
  if (child_ >= 0) collect(0);
  child_ = -1;
  wait_until([&] { return ::kill(-group, 0) != 0; });
  wait_until([&] { return at_work_in(folder_).empty(); });  // ranks of mpirun have other groups
}

void wait_for_others(const fs::path& folder) {
  constexpr int patience = 100;  // of 100 ms
  std::vector<int> others;
  for (int i = 0; i < patience && !(others = at_work_in(folder)).empty(); ++i)
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  if (others.empty()) return;
  throw InputError(Fault{folder.string(),
                         fmt::format("process {} is still at work in this folder", others.front()),
                         "wait for its end, or end it", code});
}

std::string last_error(const fs::path& folder) {
  std::string found;
  for (const char* name : {"log.lammps", "screen.txt"}) {
    std::ifstream file(folder / name);
    for (std::string line; std::getline(file, line);)
      if (line.starts_with("ERROR") || line.find("mpirun") != std::string::npos ||
          line.find("not enough slots") != std::string::npos)
        found = line;
    if (!found.empty()) return found;
  }
  return found;
}

}  // namespace mahlwerk::lammps
