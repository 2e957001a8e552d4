// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/plot/svg_plot.hpp"
#include "mahlwerk/results/outcome.hpp"

// The plots of one result.
namespace mahlwerk::report {

Plot spectrum_plot(const results::Outcome& outcome);  ///< rate per bin of energy
/// Power per bin of energy, which shows the collisions that matter.
Plot energy_weighted_plot(const results::Outcome& outcome);
Plot angle_plot(const results::Outcome& outcome);        ///< rate by impact angle
Plot temperature_plot(const results::Outcome& outcome);  ///< of balls and jar; only with [heat]
Plot rate_plot(const results::Outcome& outcome);         ///< collisions per second over time
Plot power_plot(const results::Outcome& outcome);        ///< drawn and dissipated power over time

}  // namespace mahlwerk::report
