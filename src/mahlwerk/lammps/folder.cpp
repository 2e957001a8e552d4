// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The folder of a run with LAMMPS, which is complete without Mahlwerk.
#include <fmt/format.h>

#include <fstream>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/write.hpp"
#include "mahlwerk/lammps/engine.hpp"
#include "mahlwerk/lammps/program.hpp"

namespace mahlwerk::lammps {
namespace fs = std::filesystem;
namespace {

void write(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream)
    throw InputError(Fault{file.string(), "the file cannot be written",
                           "free disk space, or choose another folder with --out", "cannot-write"});
}

/// Removes the files of an earlier run, and nothing else.
void clear(const fs::path& folder) {
  wait_for_others(folder);
  std::error_code error;
  fs::create_directories(folder, error);
  if (error)
    throw InputError(Fault{folder.string(), "the folder cannot be made: " + error.message(),
                           "choose another folder with --out", "cannot-write"});
  for (const auto& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (entry.path().extension() == ".txt" || name.starts_with("restart.") || name == "log.lammps")
      fs::remove(entry.path(), error);
  }
}

std::string readme(const cases::Case& c, const Steps& s, std::size_t balls, int ranks) {
  return fmt::format(
      "# {0}\n\n"
      "A run of Mahlwerk for LAMMPS (29 Sep 2021 or later, with the packages GRANULAR and MISC):\n"
      "{1} balls, {2} steps of {3:.6g} s. Axes are those of the laboratory, with the origin at "
      "the\n"
      "jar's centre. SI units.\n\n"
      "Begin, in this folder:\n\n"
      "    mpirun -np {4} lmp -in in.lammps\n\n"
      "Go on after an interruption, from the newer one of restart.a and restart.b; count the\n"
      "sessions 1, 2, ...:\n\n"
      "    mpirun -np {4} lmp -in in.lammps -var from restart.a -var session 1\n\n"
      "Results: copy this folder back to where it was written, and give the command that wrote it\n"
      "again, with --resume instead of --write-only or --slurm. It goes on with an unfinished "
      "run.\n\n"
      "| file | content |\n|---|---|\n"
      "| in.lammps, balls.data | input script; balls at the start |\n"
      "| case.toml | the case of Mahlwerk |\n"
      "| balance.N.txt | energies, centre of mass, power: a line in {5} steps |\n"
      "| contacts.N.txt | contacts of two balls that ended |\n"
      "| wall.N.txt | balls that began or ended a contact with the jar, every {6} steps |\n"
      "| balls.N.txt | all balls, every {7} steps |\n",
      c.title, balls, s.total, s.time_step, ranks, s.row, s.wall, s.frame);
}

}  // namespace

void write_folder(const fs::path& folder, const cases::Case& mill_case,
                  const scene::Chamber& chamber, const std::vector<scene::Ball>& balls,
                  const Steps& steps, int ranks) {
  clear(folder);
  write(folder / "balls.data", ball_file(chamber, balls));
  write(folder / "case.toml", cases::write(mill_case));
  write(folder / "README.md", readme(mill_case, steps, balls.size(), ranks));
  write(folder / "in.lammps", script(mill_case, chamber, balls, steps, ranks));
}

void write_slurm_script(const fs::path& folder, int ranks,
                        const std::vector<std::string>& options) {
  std::string more;
  for (const std::string& option : options)
    more += fmt::format("#SBATCH {}{}\n", option.starts_with("-") ? "" : "--", option);
  write(folder / "job.slurm",
        fmt::format("#!/bin/bash\n"
                    "# A run of Mahlwerk by LAMMPS. Submitted again, it goes on from its newest "
                    "restart file.\n"
                    "#SBATCH --job-name=mahlwerk-lammps\n"
                    "#SBATCH --ntasks={}\n"
                    "#SBATCH --output=slurm-%j.out\n"
                    "{}"
                    "cd \"${{SLURM_SUBMIT_DIR:-.}}\" || exit 1\n"
                    "session=$(ls from.*.txt 2>/dev/null | wc -l)\n"
                    "lammps() {{ srun lmp -in in.lammps -screen none \"$@\"; }}\n"
                    "[ -s restart.end ] && exit 0\n"
                    "[ \"$session\" = 0 ] && {{ lammps; exit; }}\n"
                    "# A restart file that was being written when the job ended cannot be read.\n"
                    "for file in $(ls -t restart.a restart.b 2>/dev/null); do\n"
                    "  lammps -var from \"$file\" -var session \"$session\" && exit 0\n"
                    "  [ -e \"from.$session.txt\" ] && exit 1\n"
                    "done\n"
                    "[ -e restart.b ] || {{ rm -f ./*.txt; lammps; }}\n",
                    ranks, more));
}

}  // namespace mahlwerk::lammps
