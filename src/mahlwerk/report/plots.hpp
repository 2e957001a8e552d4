// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/svg_plot.hpp"
#include "mahlwerk/results/outcome.hpp"

// The plots of one result.
namespace mahlwerk::report {

Plot spectrum_plot(const results::Outcome& outcome);  ///< rate per bin of energy
Plot rate_plot(const results::Outcome& outcome);      ///< collisions per second over time
Plot power_plot(const results::Outcome& outcome);     ///< drawn and dissipated power over time

}  // namespace mahlwerk::report
