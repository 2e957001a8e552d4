// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "crowd_cases.hpp"
#include "crowd_run.hpp"

// Mahlwerk and the other codes: how each is asked to run a case, one after the other, in a folder
// that holds the files of crowd_files.hpp and, in balls.bin, the balls.
namespace mahlwerk::bench {

struct CrowdProgram {
  std::string_view name, command;
  std::string_view package;  ///< Debian's
  std::string_view deck;     ///< in bench/peers/
};

inline constexpr std::array<CrowdProgram, peers> crowd_programs{{
    {"LAMMPS", "lmp", "lammps", "crowd.lmp"},
    {"LIGGGHTS", "liggghts", "liggghts", "crowd.lig"},
    {"YADE", "yade", "yade", "crowd_yade.py"},
}};

struct ProgramResult {
  double speed = 0;    ///< [particle-steps/s] of the program's own clock, in its loop of steps
  double cost = 0;     ///< [s] CPU time of a particle and step; where the program tells it
  double kinetic = 0;  ///< [J] at the end, translation and rotation
  double memory = 0;   ///< [MB] the most it held, all its processes together
  std::string fault;   ///< why there is nothing of that
};

ProgramResult run_mahlwerk(const CrowdRun& run, const std::filesystem::path& folder);

ProgramResult run_peer(Peer peer, const std::filesystem::path& folder, int steps, int cores);

/// Whether the program is here, and on more than one core what starts it there, too.
bool is_installed(Peer peer, int cores);

}  // namespace mahlwerk::bench
