// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

// Other programs, run by the benchmarks.
namespace mahlwerk::bench {

/// A new folder in the system's folder for temporary files; removed with this object.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

/// Path of a program found through PATH; empty if there is none.
std::filesystem::path find_program(std::string_view name);

struct Child {
  std::vector<std::string> words;        ///< the program and its arguments
  std::filesystem::path folder;          ///< working folder; errors go to errors.txt
  std::vector<std::string> environment;  ///< NAME=VALUE, in addition to this process's
  double limit = 0;                      ///< [s] the child is ended after this time
};

/// Ctrl-C, or another signal to end this program. The child has ended when this is thrown.
struct Interrupted {
  int signal;
};

struct ChildResult {
  std::string fault;       ///< description of the failure; empty on success
  double peak_memory = 0;  ///< [MB] of the program and its children, at the last sample
  double cpu_seconds = 0;  ///< [s] user and system, with the children that it has waited for
};

/// Runs a program to its end and passes on each line of its output, without the line's end.
ChildResult watch_child(const Child& child, const std::function<void(std::string_view)>& line);

/// The same; returns only the description of the failure.
std::string run_child(const Child& child, const std::function<void(std::string_view)>& line);

/// What a command of the program `mahlwerk` took.
struct Timing {
  double wall = 0, cpu = 0, memory = 0;  ///< [s], [s], [MB] at most
};
/// Runs the `mahlwerk` in the folder of this program to its end; a failure goes to standard error.
Timing time_mahlwerk(std::vector<std::string> words, const std::filesystem::path& folder);

/// The last error message of a program in its errors.txt and log.txt.
std::string complaint(const std::filesystem::path& folder);

}  // namespace mahlwerk::bench
