// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "crowd_cases.hpp"
#include "crowd_run.hpp"

// Runs Mahlwerk and the other codes on a case, one after the other, in a folder with the files of
// crowd_files.hpp and with the balls in balls.bin.
namespace mahlwerk::bench {

struct CrowdProgram {
  std::string_view name, command;
  std::string_view package;  ///< Debian package
  std::string_view deck;     ///< in bench/peers/
};

inline constexpr std::array<CrowdProgram, peers> crowd_programs{{
    {"LAMMPS", "lmp", "lammps", "crowd.lmp"},
    {"LIGGGHTS", "liggghts", "liggghts", "crowd.lig"},
    {"YADE", "yade", "yade", "crowd_yade.py"},
}};

struct ProgramResult {
  double speed = 0;    ///< [particle-steps/s] by the program's own clock, in its loop of time steps
  double cost = 0;     ///< [s] CPU time per particle and step, if the program reports it
  double kinetic = 0;  ///< [J] at the end, translation and rotation
  double memory = 0;   ///< [MB] peak of all its processes together
  std::string fault;   ///< why there is no result
};

ProgramResult run_mahlwerk(const CrowdRun& run, const std::filesystem::path& folder);

ProgramResult run_peer(Peer peer, const std::filesystem::path& folder, int steps, int cores);

/// Whether the program is installed and, if it needs it on several cores, mpirun.
bool is_installed(Peer peer, int cores);

}  // namespace mahlwerk::bench
