// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/lammps_runs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/campaign/run/replicate.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/reversal.hpp"
#include "mahlwerk/lammps/engine.hpp"

namespace mahlwerk::campaign {

lammps::Steps lammps_steps(const cases::Case& mill_case, const SoftSettings& s) {
  const cases::Run& run = mill_case.run;
  return lammps::steps_of(mill_case, run.settle.value_or(0) + run.time, run.time, s.rules.time_step,
                          s.steps.contact);
}

int usual_ranks(const cases::Case& mill_case, int cores) {
  constexpr std::int64_t balls_per_rank = 2000;
  const std::int64_t most = cases::balls_count(mill_case.balls) / balls_per_rank;
  return static_cast<int>(std::clamp<std::int64_t>(most, 1, std::max(1, cores)));
}

std::filesystem::path lammps_folder(const std::filesystem::path& root, std::size_t point,
                                    std::size_t points, int replicate) {
  const std::string own = fmt::format("replicate-{}", replicate + 1);
  return points > 1 ? root / fmt::format("point-{}", point + 1) / own : root / own;
}

std::vector<std::filesystem::path> write_lammps_folders(
    const cases::Case& mill_case, const lammps::Launch& launch, bool slurm,
    const std::vector<std::string>& slurm_options) {
  std::vector<std::filesystem::path> folders;
  const cases::CaseBySense by_sense(mill_case);
  for (int replicate = 0; replicate < mill_case.run.replicates; ++replicate) {
    const cases::Case& own = by_sense.of(static_cast<std::size_t>(replicate));
    folders.push_back(lammps_folder(launch.folder, 0, 1, replicate));
    const RunSetup setup(own);
    lammps::write_folder(folders.back(), own, setup.chamber, start_of(setup, replicate),
                         *setup.steps, launch.ranks);
    if (slurm) lammps::write_slurm_script(folders.back(), launch.ranks, slurm_options);
  }
  return folders;
}

}  // namespace mahlwerk::campaign
