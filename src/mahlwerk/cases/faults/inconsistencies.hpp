// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

// The parts of faults() of read.hpp.
namespace mahlwerk::cases {

/// Values out of range, for a case that was constructed without a reader.
std::vector<Fault> bad_values(const Case& c);
/// Inconsistencies between valid parts of a case. Ignores values that are `invalid_value`.
std::vector<Fault> inconsistencies(const Case& c);

// Called by inconsistencies().

/// Given initial positions outside the jar, and overlaps with its wall or between balls. For a case
/// without other inconsistencies.
void bad_positions(const Case& c, std::vector<Fault>& found);
/// Parts in the jar that lie outside it, that no ball can pass, or that the engine cannot move.
void bad_parts(const Case& c, std::vector<Fault>& found);
/// Parts in a periodic jar that do not fit together with their images. For parts without other
/// faults.
void bad_part_images(const Case& c, std::vector<Fault>& found);
/// Given initial positions in a part of the mill. For parts without faults.
void balls_in_parts(const Case& c, std::vector<Fault>& found);
/// A start state with other balls, or too few states for the replicates.
void bad_start_state(const Case& c, std::vector<Fault>& found);
/// A mill that cannot speed up, or counting that begins before it has its speed.
void bad_ramp(const Case& c, std::vector<Fault>& found);
/// A speed over time of a mill without a speed, or beside another section that decides it.
void bad_speed_over_time(const Case& c, std::vector<Fault>& found);
/// Solid volume of powder and balls larger than the jar.
void bad_powder(const Case& c, std::vector<Fault>& found);
/// A reversed drive ([milling] reverse) of a mill that does not turn, of a single cycle, or with
/// unequal numbers of replicates in its two senses.
void bad_reversal(const Case& c, std::vector<Fault>& found);

}  // namespace mahlwerk::cases
