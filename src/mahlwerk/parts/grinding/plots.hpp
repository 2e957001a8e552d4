// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/plot/plot.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::parts::grinding {

using report::Plot;

/// Of a result with [capture]: captured grains and their specific energy over the collision energy,
/// for the pair kinds with the most power; collisions by captured grains.
Plot capture_plot(const results::Outcome& outcome);
Plot captured_energy_plot(const results::Outcome& outcome);
Plot captured_grains_plot(const results::Outcome& outcome);

/// Of a result with [grinding]. With both methods, the sample of grains is dashed.
Plot sizes_plot(const results::Outcome& outcome);    ///< D10, D50 and D90 over time
Plot passing_plot(const results::Outcome& outcome);  ///< cumulative distribution at several times
Plot density_plot(const results::Outcome& outcome);  ///< density at the same times
Plot surface_plot(const results::Outcome& outcome);  ///< specific surface over time

}  // namespace mahlwerk::parts::grinding
