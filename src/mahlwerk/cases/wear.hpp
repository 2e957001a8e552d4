// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>

namespace mahlwerk::cases {

struct Case;

/// Wear of balls, jar and parts: the section [wear] (docs/theory/wear-heat.md).
struct Wear {
  enum class Model {
    archard,  ///< by normal force and sliding distance (wea.1)
    finnie,   ///< by energy and angle of each impact (wea.4)
    energy    ///< by the energy that contacts lose (wea.8)
  };
  Model model = Model::archard;
  double coefficient = 1e-4;  ///< [1] Archard's K, Finnie's k, or that of the energy
  /// [s] of operation over which shapes and sizes follow the wear; none: they stay
  std::optional<double> evolve = std::nullopt;
  double largest_change = 0.1;  ///< [1] of a profile's height or a ball's diameter in one stage
  double worn_out = 0.5;        ///< [1] share of its height that ends the life of a profile
  bool make_up = false;         ///< whether fresh balls replace what the balls of a set lost
  double scrap_size = 0;        ///< [m] balls below leave
  bool operator==(const Wear&) const = default;
};

/// What contacts have done to a body, or do per second.
struct ContactSums {
  double slid = 0;     ///< [N m] normal force times sliding distance
  double erosion = 0;  ///< [J] sum of m u^2 f(alpha) (wea.4)
  double lost = 0;     ///< [J] dissipated energy
};
/// [m3], or [m3/s] of sums per second: volume worn off a body of a Vickers hardness > 0.
double worn_volume(const Wear& wear, const ContactSums& sums, double vickers);

/// Whether shapes and sizes follow their wear: the case is followed in stages and is no single run.
bool evolves(const Case& c);
/// The case with the shapes that it gives, which stay.
Case of_one_run(Case c);

}  // namespace mahlwerk::cases
