// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/lammps/launch.hpp"
#include "mahlwerk/lammps/program.hpp"

namespace mahlwerk::lammps {

/// A run of LAMMPS in its folder: begun, gone on with, or complete.
class Run {
 public:
  /// Makes a temporary folder, removed with this object, if `launch` names none.
  explicit Run(const Launch& launch);
  ~Run();
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  const std::filesystem::path& folder() const { return folder_; }
  int ranks() const { return ranks_; }
  /// Whether the folder holds a run that goes on.
  bool resumes() const { return resumes_; }

  /// Starts LAMMPS, unless the run has reached step `last`: a run that goes on from the newest
  /// restart file that LAMMPS can read. Throws InputError if the folder is that of another case, or
  /// LAMMPS is missing; RunError if it cannot be started.
  void start(const cases::Case& mill_case, std::int64_t last);
  bool ended();
  void stop();
  /// [s] CPU time of LAMMPS in this run and in those that it goes on with, as far as they ended.
  double cpu_seconds() const { return earlier_cpu_ + (running_ ? running_->cpu_seconds() : 0); }
  /// Throws the RunError of a LAMMPS that stopped at `time` [s].
  [[noreturn]] void end_early(double time) const;

 private:
  void check_case(const cases::Case& mill_case) const;
  bool is_complete(std::int64_t last) const;
  std::vector<std::string> command() const;
  bool start_from_restart_file();
  std::vector<std::filesystem::path> restart_files() const;
  void keep_cpu_seconds() const;

  std::filesystem::path folder_;
  bool temporary_ = false, resumes_ = false;
  int ranks_ = 1;
  double earlier_cpu_ = 0;  // [s]
  std::unique_ptr<Running> running_;
};

}  // namespace mahlwerk::lammps
