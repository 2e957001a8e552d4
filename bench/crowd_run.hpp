// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/scene/balls.hpp"

// Mahlwerk's own runs with many balls, each in a separate process, as the runs of the other
// programs.
namespace mahlwerk::bench {

struct CrowdRun {
  std::string name;  ///< of the case
  int threads = 1;
  int lead = 0, steps = 0;           ///< not measured, then measured
  double start = 0;                  ///< [s] on the mill's clock
  std::string from = "-", to = "-";  ///< files of balls; "-": from the case's filling, to nowhere
};

/// First argument of a command line that requests such a run of this program. The other arguments
/// are `words`.
inline constexpr std::string_view crowd_run_option = "--crowd-run";
std::vector<std::string> arguments_for(const CrowdRun& run);

/// Writes log.txt in the format of LAMMPS: the kinetic energy and the times of the measured steps.
int perform_crowd_run(const std::vector<std::string>& words);

std::vector<scene::Ball> read_balls(const std::filesystem::path& file);

}  // namespace mahlwerk::bench
