// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"

// LAMMPS as a program of its own (POSIX).
namespace mahlwerk::lammps {

/// The LAMMPS of this machine, and what it cannot do.
struct Installed {
  std::string command;        ///< "lmp"
  std::string version;        ///< "29 Sep 2021"
  std::vector<Fault> faults;  ///< what is missing, and how to install it; empty if nothing is
};
/// Looks for `lmp` or `lmp_mpi` on the search path, or the program that the environment variable
/// MAHLWERK_LAMMPS names, and for `mpirun` if there is more than one rank.
Installed installed(int ranks);

/// LAMMPS at work in a folder. It ends with this object, and with the thread that started it.
class Running {
 public:
  /// Starts `words` in `folder`, with its output in the file screen.txt there. Throws RunError.
  Running(const std::filesystem::path& folder, const std::vector<std::string>& words);
  ~Running() { stop(); }
  Running(const Running&) = delete;
  Running& operator=(const Running&) = delete;

  bool ended();  ///< whether it has ended by itself
  bool succeeded() const { return status_ == 0; }
  void stop();  ///< ends it and all its ranks, and waits
  /// [s] CPU time of it and its ranks, once it has ended.
  double cpu_seconds() const { return cpu_seconds_; }

 private:
  bool collect(int options);

  std::filesystem::path folder_;
  int child_ = -1, status_ = -1;
  double cpu_seconds_ = 0;
};

/// Waits until no LAMMPS of an earlier run is at work in `folder`, for up to ten seconds. Throws
/// InputError if one still is.
void wait_for_others(const std::filesystem::path& folder);

/// The last error message in a log file of LAMMPS or on its screen; empty if there is none.
std::string last_error(const std::filesystem::path& folder);

}  // namespace mahlwerk::lammps
