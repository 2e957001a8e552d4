// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/plot/svg_plot.hpp"
#include "mahlwerk/results/outcome.hpp"

// The plots of what becomes of the powder.
namespace mahlwerk::report {

/// Of a result with [capture]: grains caught, and what they get by their mass, by the energy of the
/// collision, for the kinds of pairs that carry most power; collisions by grains caught.
Plot catch_plot(const results::Outcome& outcome);
Plot caught_energy_plot(const results::Outcome& outcome);
Plot caught_grains_plot(const results::Outcome& outcome);

/// Of a result with [grinding]. Where there is a sample beside the balance it is dashed.
Plot sizes_plot(const results::Outcome& outcome);    ///< D10, D50 and D90 over time
Plot passing_plot(const results::Outcome& outcome);  ///< share finer than a size, at some times
Plot density_plot(const results::Outcome& outcome);  ///< share by size, at the same times
Plot surface_plot(const results::Outcome& outcome);  ///< specific surface over time

/// Of a result with [kinetics]: conversion or, where the case names one, the property over time.
Plot conversion_plot(const results::Outcome& outcome);
Plot property_plot(const results::Outcome& outcome);

}  // namespace mahlwerk::report
