// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "mahlwerk/scene/engine.hpp"

// Cases with many balls: drums with the same bed of ever smaller spheres, and balls among grains.
namespace mahlwerk::bench {

/// The other codes, in the order of all arrays with an element for each code.
enum Peer { lammps, liggghts, yade };
inline constexpr int peers = 3;

struct CrowdCase {
  std::string name, what;
  scene::Chamber mill;
  double radius = 0, height = 0;                   ///< [m] of the jar
  std::function<std::vector<scene::Ball>()> fill;  ///< before the warm-up
  double youngs_modulus = 0;                       ///< [Pa]
  double step = 0;                                 ///< [s]
  int warm_up = 0;                                 ///< [steps]
  int steps = 0;                                   ///< measured
  std::array<int, peers> peer_steps{};             ///< a turn of the others takes seconds, too
  std::string processors, search;                  ///< LAMMPS: domain decomposition, pair search
  double skin = 0;                                 ///< [m] about the best for LAMMPS and LIGGGHTS
  double margin = 0;                               ///< [1] YADE's skin over the smallest radius
  double rolling_stiffness = 0;                    ///< LAMMPS's
  double bending_stiffness = 0;                    ///< [N m] YADE's, one for all pairs
};

/// 10 000, 100 000 or 1 000 000 spheres.
CrowdCase drum(int count);

/// Five balls and 20 000 grains in a planetary mill.
CrowdCase powder();

/// The case of that name.
CrowdCase crowd_case(std::string_view name);

std::unique_ptr<scene::Engine> engine(const CrowdCase& c, const std::vector<scene::Ball>& balls,
                                      int threads, double start);

}  // namespace mahlwerk::bench
