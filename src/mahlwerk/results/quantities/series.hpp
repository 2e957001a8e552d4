// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// The quantities of summary.json that every window of time has a value of.
const std::vector<std::string>& series_names();

/// One of them, window by window; empty for any other name. A window in which it does not exist is
/// left out.
std::vector<double> series(const std::vector<Window>& windows, std::string_view name);

/// Half-width of the 95 % confidence interval of the replicates' mean that their scatter over time
/// gives; NaN where there is no series.
double ci95_over_time(const std::vector<const Replicate*>& replicates, std::string_view name);

/// [s] of the counted time that still belongs to the start, by the dissipated power of all
/// replicates together (sta.5); half the time or more: it has not settled.
double settling_time(const std::vector<const Replicate*>& replicates);

}  // namespace mahlwerk::results
