// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// The time series of a quantity that has a value in each window (QuantityTraits::over_time); empty
/// for any other name. Windows without a finite value are left out.
std::vector<double> series(const std::vector<Window>& windows, std::string_view name);

/// Half-width of the 95 % confidence interval of the replicates' mean, from the scatter over time;
/// NaN where there is no series.
double ci95_over_time(const std::vector<const Replicate*>& replicates, std::string_view name);

/// [s] Initial transient within the counted time, by the dissipated power of all replicates
/// together (MSER-5, sta.5). Half the counted time or more: the charge has not settled.
double settling_time(const std::vector<const Replicate*>& replicates);

}  // namespace mahlwerk::results
