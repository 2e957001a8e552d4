// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/cases/case.hpp"

// What is wrong with a case, part by part; faults() of read.hpp is all of it.
namespace mahlwerk::cases {

/// Values out of range, for a case that no reader has seen.
std::vector<Fault> bad_values(const Case& c);
/// Faults of parts that were read but do not go together; silent about what is `invalid_value`.
std::vector<Fault> inconsistencies(const Case& c);

// Within inconsistencies().

/// Given starting places outside the jar, in its wall or in each other. For parts that fit
/// otherwise.
void bad_positions(const Case& c, std::vector<Fault>& found);
/// Of the powder and the sections of grinding.
void bad_powder(const Case& c, std::vector<Fault>& found);
void bad_grinding(const Case& c, std::vector<Fault>& found);

}  // namespace mahlwerk::cases
