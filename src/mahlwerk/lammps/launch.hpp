// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>

namespace mahlwerk::lammps {

/// Where LAMMPS computes a run, and how.
struct Launch {
  std::filesystem::path folder;  ///< empty: a temporary one, removed at the end
  int ranks = 0;                 ///< processes of one run; 0: by balls and threads, else 1
  bool resume = false;           ///< go on with, or read, what the folder holds
};

}  // namespace mahlwerk::lammps
