// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

// The sizes of a ball charge that wears, with make-up of fresh balls (wea.13 to wea.17).
namespace mahlwerk::powder {

/// Balls that were added together and wear together. Their number may be a fraction: it is that of
/// a charge that the simulated balls stand for.
struct Cohort {
  double diameter = 0;    ///< [m]
  double number = 0;      ///< [1]
  double volume() const;  ///< [m3] of all its balls
  bool operator==(const Cohort&) const = default;
};
using BallCharge = std::vector<Cohort>;  ///< the largest balls first

double volume_of(const BallCharge& charge);  ///< [m3]
double sphere_volume(double diameter);       ///< [m3]
double sphere_diameter(double volume);       ///< [m]

/// Wears each ball of cohort i by `volumes[i]` [m3], at most its own volume. Returns what all have
/// lost [m3] (wea.13).
double wear_down(BallCharge& charge, const std::vector<double>& volumes);
/// Removes the balls below `size` [m]. Returns their volume [m3].
double scrap_below(BallCharge& charge, double size);
/// Adds fresh balls of `size` [m] with this `volume` [m3] in all.
void add_fresh(BallCharge& charge, double size, double volume);
/// Joins neighbours, the most alike first, until there are at most `most` >= 1; their number and
/// volume stay (wea.14).
void join_cohorts(BallCharge& charge, std::size_t most);

/// Whole numbers of balls of each cohort: what rounding leaves of a volume is carried to the next
/// smaller size, so that the volume of all differs by at most half a ball of the last size.
std::vector<long long> whole_numbers(const BallCharge& charge);

/// [1] Share of the mass below `size` in the steady state of a charge with make-up at `fresh` and
/// scrap at `scrap` [m], if the diameter of a ball shrinks in proportion to its power `exponent`: 0
/// for linear wear (wea.15), 1 for wear in proportion to the mass (wea.16). Not for 4.
double steady_mass_below(double size, double scrap, double fresh, double exponent);

}  // namespace mahlwerk::powder
