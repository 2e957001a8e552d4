// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "peers.hpp"

// The other codes: how each is asked to run the case, on one core.
namespace mahlwerk::bench {

struct Program {
  std::string_view name, command;
  std::string_view package;           ///< Debian's
  std::string_view deck;              ///< in bench/peers/
  int steps;                          ///< that take a few seconds
  std::string_view numbers = "once";  ///< of LAMMPS's deck
};

inline constexpr std::array programs{
    Program{"LAMMPS", "lmp", "lammps", "planetary.lmp", 300000},
    Program{"LAMMPS as commonly written", "lmp", "lammps", "planetary.lmp", 300000, "looked_up"},
    Program{"LIGGGHTS", "liggghts", "liggghts", "planetary.lig", 50000},
    Program{"YADE", "yade", "yade", "planetary_yade.py", 30000},
};

/// Either what was found, or why there is nothing.
template <typename T>
struct Expected {
  T value{};
  std::string fault;
};

/// Particle-steps per second of the program's own clock, in its loop of steps alone.
Expected<double> speed_of(const Program& program, const Start& start);

Expected<Physics> physics_of(const Program& program, const Start& start);

}  // namespace mahlwerk::bench
