// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string>
#include <string_view>

#include "peers.hpp"

// The other codes, and their runs of the case on one core.
namespace mahlwerk::bench {

struct Program {
  std::string_view name, command;
  std::string_view package;           ///< Debian package
  std::string_view deck;              ///< in bench/peers/
  int steps;                          ///< number that takes a few seconds
  std::string_view numbers = "once";  ///< variable of LAMMPS's deck
};

inline constexpr std::array programs{
    Program{"LAMMPS", "lmp", "lammps", "planetary.lmp", 300000},
    Program{"LAMMPS as commonly written", "lmp", "lammps", "planetary.lmp", 300000, "looked_up"},
    Program{"LIGGGHTS", "liggghts", "liggghts", "planetary.lig", 50000},
    Program{"YADE", "yade", "yade", "planetary_yade.py", 30000},
};

/// Either a value, or the reason why there is none.
template <typename T>
struct Expected {
  T value{};
  std::string fault;
};

/// Particle-steps per CPU second of the whole program, the clock that measures Mahlwerk, too. Two
/// runs of different length, whose difference is free of the program's start.
Expected<double> speed_of(const Program& program, const Start& start);

Expected<Physics> physics_of(const Program& program, const Start& start);

}  // namespace mahlwerk::bench
