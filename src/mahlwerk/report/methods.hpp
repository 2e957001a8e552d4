// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// The replicates that means are taken over.
struct CountedRuns {
  std::size_t replicates = 1;
  double time = 0;                                ///< [s] counted time of each, the mean
  std::optional<double> settling = std::nullopt;  ///< [s] before; none: until the mill had settled
};

/// A methods paragraph for a paper. An asterisk marks every assumed value: a default that the case
/// does not give.
std::string methods(const results::Outcome& outcome, std::string_view version);
/// The same of a case that `engine`, never auto, runs or ran.
std::string methods(const cases::Case& c, cases::EngineName engine, const CountedRuns& runs,
                    std::string_view version);

}  // namespace mahlwerk::report
