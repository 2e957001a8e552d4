// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "mahlwerk/campaign/run/run.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Reads the case of a run again, with the value `text` for `key`. Throws InputError.
using ReadWithValue = std::function<cases::Case(const std::string& key, const std::string& text)>;

/// Runs of one replicate at both ends of the plausible range of each assumed value of an ended run
/// (docs/theory/statistics.md, "Assumed values"). Keys are left out, in the order of the case, once
/// the runs would simulate more time than the run itself. No value if no assumed value has a range,
/// if the case switches these runs off, or if the run or one of them did not end.
std::optional<results::Sensitivity> sensitivity_to_assumed(const results::Outcome& outcome,
                                                           const ReadWithValue& read,
                                                           const RunOptions& options);

/// Time that these runs simulate over that of the run itself, for a case whose engine is decided
/// and whose replicates settle in `settling` [s].
double assumed_values_cost(const cases::Case& decided, double settling);

}  // namespace mahlwerk::campaign
