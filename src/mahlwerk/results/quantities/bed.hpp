// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/results/quantities/measure.hpp"
#include "mahlwerk/results/table.hpp"

// The bed of a drum from the mean fields of its charge: slope, surface layer and velocity profile
// (obs.10, obs.11).
namespace mahlwerk::results {

/// The profile of a replicate, in steps of half a cell from one wall through the axis to the other.
/// Empty for a mill that is not a drum, or without a charge.
std::vector<BedPoint> bed_profile(const cases::Case& mill_case, const Replicate& r);

/// Slope of the bed, distance of its centre of mass, surface speed, boundary and shear rate of the
/// surface layer (drums), and height of the centre of mass (other mills in an upright plane).
Measures bed_measures();

/// bed.csv: the profile with intervals over replicates.
Table bed_table(const Outcome& outcome);

}  // namespace mahlwerk::results
