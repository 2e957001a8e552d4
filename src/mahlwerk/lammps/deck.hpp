// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/scene/balls.hpp"

// A case as input files of LAMMPS, which runs as a program of its own (docs/theory/lammps.md).
namespace mahlwerk::lammps {

/// Time stepping of a run, and how often LAMMPS writes.
struct Steps {
  double time_step = 0;         ///< [s]
  std::int64_t settle = 0;      ///< steps that are not counted
  std::int64_t counted = 0;     ///< steps after these
  std::int64_t sampling = 100;  ///< steps between two samples of wall forces
  std::int64_t rows = 200;      ///< lines of the log in the counted time
};

/// The files that LAMMPS reads: the input script, and the balls.
struct Deck {
  std::string script, balls;
};

/// Why LAMMPS cannot run the case; empty if it can. Each fault lists what it can.
std::vector<Fault> faults(const cases::Case& mill_case);

/// The case for LAMMPS with these balls at the start, in the jar frame. Throws InputError with
/// faults().
Deck deck(const cases::Case& mill_case, const std::vector<scene::Ball>& balls, const Steps& steps);

}  // namespace mahlwerk::lammps
