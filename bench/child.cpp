// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "child.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <system_error>

#include "memory.hpp"

namespace mahlwerk::bench {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

volatile std::sig_atomic_t wished_to_end = 0;

/// During the lifetime of this object, signals to end this program are only recorded, so the child
/// can be ended and its folder removed first.
class SignalGuard {
 public:
  SignalGuard() {
    wished_to_end = 0;
    struct sigaction action {};
    action.sa_handler = [](int signal) { wished_to_end = signal; };
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &action, &before_[i]);
  }
  ~SignalGuard() {
    for (std::size_t i = 0; i < signals.size(); ++i) sigaction(signals[i], &before_[i], nullptr);
  }
  SignalGuard(const SignalGuard&) = delete;
  SignalGuard& operator=(const SignalGuard&) = delete;

 private:
  static constexpr std::array signals{SIGINT, SIGTERM, SIGHUP};
  std::array<struct sigaction, signals.size()> before_{};
};

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close_now(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close_now() {
    if (number_ >= 0) close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

std::vector<char*> pointers(std::vector<std::string>& words) {
  std::vector<char*> found;
  found.reserve(words.size() + 1);
  for (std::string& word : words) found.push_back(word.data());
  found.push_back(nullptr);
  return found;
}

/// The environment of this process. Entries of the child replace entries of the same name.
std::vector<std::string> environment_of(const Child& child) {
  const auto name = [](std::string_view entry) { return entry.substr(0, entry.find('=') + 1); };
  std::vector<std::string> all = child.environment;
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (std::none_of(child.environment.begin(), child.environment.end(),
                     [&](const std::string& own) { return name(own) == name(*entry); }))
      all.emplace_back(*entry);
  return all;
}

/// Starts the child in its own process group, which can be ended together with everything that it
/// starts.
pid_t start(const Child& child, int output) {
  std::vector<std::string> words = child.words, environment = environment_of(child);
  const std::vector<char*> arguments = pointers(words), variables = pointers(environment);
  const std::string folder = child.folder, errors = child.folder / "errors.txt";
  const pid_t parent = getpid(), id = fork();
  if (id != 0) {
    if (id > 0) setpgid(id, id);
    return id;
  }
  setpgid(0, 0);
  prctl(PR_SET_PDEATHSIG, SIGKILL);  // if this process is killed outright
  const int nothing = open("/dev/null", O_RDONLY | O_CLOEXEC);
  const int complaints = open(errors.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (getppid() == parent && nothing >= 0 && complaints >= 0 && chdir(folder.c_str()) == 0 &&
      dup2(nothing, 0) == 0 && dup2(output, 1) == 1 && dup2(complaints, 2) == 2)
    execvpe(arguments[0], arguments.data(), variables.data());
  _exit(127);
}

/// Splits the received text into lines.
class Lines {
 public:
  explicit Lines(const std::function<void(std::string_view)>& line) : line_(line) {}

  void add(std::string_view text) {
    for (std::size_t end = 0; (end = text.find('\n')) != text.npos; text.remove_prefix(end + 1)) {
      begun_.append(text.substr(0, end));
      line_(begun_);
      begun_.clear();
    }
    begun_.append(text);
  }

 private:
  const std::function<void(std::string_view)>& line_;
  std::string begun_;
};

/// Samples the memory of a process now and then.
class MemoryWatch {
 public:
  explicit MemoryWatch(pid_t id) : id_(id) {}

  void sample() {
    if (Clock::now() < next_) return;
    next_ = Clock::now() + between;
    peak_ = std::max(peak_, peak_memory(id_));
  }
  double peak() const { return peak_; }

 private:
  // Right after the fork the child is still a copy of this process.
  static constexpr std::chrono::milliseconds first{100}, between{400};
  pid_t id_;
  Clock::time_point next_ = Clock::now() + first;
  double peak_ = 0;
};

/// Reads until the child closes its output. Returns false if the time is up before.
bool read_all(int input, Clock::time_point last, Lines lines, MemoryWatch& memory) {
  std::vector<char> buffer(1 << 16);
  while (Clock::now() < last) {
    if (wished_to_end != 0) throw Interrupted{wished_to_end};
    memory.sample();
    pollfd ready{input, POLLIN, 0};
    constexpr int patience = 200;  // [ms] a signal may come just before poll waits
    if (poll(&ready, 1, patience) <= 0) continue;
    const ssize_t count = read(input, buffer.data(), buffer.size());
    if (count == 0) return true;
    if (count > 0) lines.add({buffer.data(), static_cast<std::size_t>(count)});
  }
  return false;
}

/// Owns the child process: the destructor ends it if it still runs.
class ChildProcess {
 public:
  explicit ChildProcess(pid_t id) : id_(id) {}
  ~ChildProcess() {
    if (id_ <= 0) return;
    kill(-id_, SIGKILL);
    waitpid(id_, nullptr, 0);
  }
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// The exit status of a child that has ended by itself; -1 if the time is up before.
  int ended(Clock::time_point last) {
    int status = 0;
    while (wait4(id_, &status, WNOHANG, &usage_) == 0) {
      if (wished_to_end != 0) throw Interrupted{wished_to_end};
      if (Clock::now() > last) return -1;
      usleep(5000);
    }
    id_ = 0;
    return status;
  }
  /// CPU time [s] of a child that has ended.
  double cpu_seconds() const {
    const auto seconds = [](const timeval& t) {
      return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
    };
    return seconds(usage_.ru_utime) + seconds(usage_.ru_stime);
  }

 private:
  pid_t id_;
  rusage usage_{};
};

}  // namespace

TemporaryFolder::TemporaryFolder() {
  std::string name = fs::temp_directory_path() / "mahlwerk-bench-XXXXXX";
  if (mkdtemp(name.data()) == nullptr)
    throw std::system_error(errno, std::generic_category(), "cannot make the folder " + name);
  path_ = name;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

fs::path find_program(std::string_view name) {
  const char* path = std::getenv("PATH");
  std::string_view rest = path == nullptr ? "" : path;
  while (!rest.empty()) {
    const std::string_view folder = rest.substr(0, rest.find(':'));
    rest.remove_prefix(std::min(folder.size() + 1, rest.size()));
    fs::path found = fs::path(folder) / name;
    if (fs::is_regular_file(found) && access(found.c_str(), X_OK) == 0) return found;
  }
  return {};
}

ChildResult watch_child(const Child& child, const std::function<void(std::string_view)>& line) {
  const Clock::time_point last = Clock::now() + std::chrono::duration_cast<Clock::duration>(
                                                    std::chrono::duration<double>(child.limit));
  const SignalGuard noting;
  int ends[2];
  if (pipe2(ends, O_CLOEXEC) != 0) return {std::strerror(errno)};
  const Descriptor input(ends[0]);
  Descriptor output(ends[1]);
  const pid_t id = start(child, output.number());
  if (id < 0) return {std::strerror(errno)};
  ChildProcess running(id);
  output.close_now();
  MemoryWatch memory(id);
  const bool closed = read_all(input.number(), last, Lines(line), memory);
  const int status = closed ? running.ended(last) : -1;
  ChildResult ended{{}, memory.peak(), running.cpu_seconds()};
  if (status == -1)
    ended.fault = fmt::format("not finished after {:.0f} s, killed", child.limit);
  else if (WIFSIGNALED(status))
    ended.fault = fmt::format("ended by signal {}", WTERMSIG(status));
  else if (WEXITSTATUS(status) != 0)
    ended.fault = fmt::format("ended with code {}", WEXITSTATUS(status));
  return ended;
}

std::string complaint(const std::filesystem::path& folder) {
  std::string line, last;
  for (const char* name : {"errors.txt", "log.txt"}) {
    std::ifstream file(folder / name);
    while (std::getline(file, line))
      if (line.find("ERROR") != line.npos || line.find("Error") != line.npos) last = line;
  }
  return last;
}

Timing time_mahlwerk(std::vector<std::string> words, const fs::path& folder) {
  constexpr double long_enough = 1800;  // [s]
  words.insert(words.begin(), fs::read_symlink("/proc/self/exe").parent_path() / "mahlwerk");
  const auto began = Clock::now();
  const ChildResult ended =
      watch_child({.words = words, .folder = folder, .environment = {}, .limit = long_enough},
                  [](std::string_view) {});
  if (!ended.fault.empty())
    fmt::print(stderr, "bench: {}: {} {}\n", fmt::join(words, " "), ended.fault, complaint(folder));
  return {std::chrono::duration<double>(Clock::now() - began).count(), ended.cpu_seconds,
          ended.peak_memory};
}

std::string run_child(const Child& child, const std::function<void(std::string_view)>& line) {
  return watch_child(child, line).fault;
}

}  // namespace mahlwerk::bench
