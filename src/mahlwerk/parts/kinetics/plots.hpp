// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/report/plot/plot.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::parts::kinetics {

using report::Plot;

/// Of a result with [kinetics]: conversion over time, and the property over time if the case names
/// one.
Plot conversion_plot(const results::Outcome& outcome);
Plot property_plot(const results::Outcome& outcome);

}  // namespace mahlwerk::parts::kinetics
