// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/plot/plot.hpp"
#include "mahlwerk/results/outcome.hpp"

// The plots of one outcome.
namespace mahlwerk::report {

Plot spectrum_plot(const results::Outcome& outcome);  ///< collision rate by energy
/// Power by collision energy: shows which collisions carry the power.
Plot energy_weighted_plot(const results::Outcome& outcome);
Plot angle_plot(const results::Outcome& outcome);  ///< collision rate by impact angle
Plot rate_plot(const results::Outcome& outcome);   ///< collisions per second over time
Plot power_plot(const results::Outcome& outcome);  ///< power input and dissipated power over time

}  // namespace mahlwerk::report
