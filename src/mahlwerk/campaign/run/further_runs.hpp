// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/campaign/run/run.hpp"

// What further runs share, by which a single run tests its result.
namespace mahlwerk::campaign {

/// The quantities that they compare.
constexpr std::array<std::string_view, 3> first_answers{
    "dissipated_power", "collision_rate_above_threshold", "energy_normal_mean_above_threshold"};

/// The case without records, powder and its kinetics.
cases::Case without_records(cases::Case mill_case);

/// The options without files, states and progress, which are those of the run itself.
RunOptions without_files(RunOptions options);

}  // namespace mahlwerk::campaign
