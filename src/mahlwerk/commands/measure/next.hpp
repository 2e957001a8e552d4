// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/commands/measure/measured.hpp"

// What to measure next.
namespace mahlwerk::commands {

/// The value whose interval changes the energies most, by known powers: energies of hits grow with
/// the square of lengths, angles and speeds of the mill, and a hit loses 1 - e^2 of its energy
/// (mea.15). Over measured intervals and the ranges of values that the case, or without one the
/// entry, assumes. A sentence with its own line end.
std::string next_by_powers(const Measured& measured, const std::optional<cases::Case>& mill_case);

/// The same by runs: the bands of the results of the case, and what makes them wide. Empty if the
/// runs were interrupted.
std::string next_by_runs(const MeasureOutput& given, const Measured& measured);

/// The case with the measured values. Throws InputError.
cases::Case case_with(const MeasureOutput& given, const Measured& measured,
                      const std::vector<cases::Override>& more = {});

}  // namespace mahlwerk::commands
