// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/cases/case.hpp"
#include "mahlwerk/results/files/json_value.hpp"

// Conditions and results of a run as PropertyValue entities of JSON-LD (schema.org).
namespace mahlwerk::report {

/// Each value of the case, with its key as propertyID and its source in the description, and the
/// volume of the jar.
std::vector<results::Json> condition_values(const cases::Case& c);

/// Each quantity of summary.json that has a value, the key quantities first, with its 95 %
/// confidence interval.
std::vector<results::Json> result_values(const results::Json& summary);

}  // namespace mahlwerk::report
