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

/// A folder of its own under the system's place for such things; gone with this object.
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

/// Where PATH finds a program; empty if it does not.
std::filesystem::path find_program(std::string_view name);

struct Child {
  std::vector<std::string> words;        ///< the program and its arguments
  std::filesystem::path folder;          ///< it works there; its errors go to errors.txt
  std::vector<std::string> environment;  ///< NAME=VALUE, beside what this process has
  double limit = 0;                      ///< [s] it is ended after that
};

/// Ctrl-C, or another wish that this program end. The child has ended when this is thrown.
struct Interrupted {
  int signal;
};

struct ChildResult {
  std::string fault;       ///< what went wrong; nothing if all went well
  double peak_memory = 0;  ///< [MB] of the program and those it started, as last seen
};

/// Runs a program to its end and hands over each line that it writes, without the line's end.
ChildResult watch_child(const Child& child, const std::function<void(std::string_view)>& line);

/// The same; tells what went wrong.
std::string run_child(const Child& child, const std::function<void(std::string_view)>& line);

/// What a program said last about why it gave up, in its errors.txt and log.txt.
std::string complaint(const std::filesystem::path& folder);

}  // namespace mahlwerk::bench
