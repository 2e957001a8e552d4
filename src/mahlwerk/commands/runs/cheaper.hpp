// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::commands {

/// Keys that make a run of `seconds` [s] cheaper, each with the time that the run would then take:
/// softening, where overlaps stay bearable, and replicates. Empty for a run that is not long.
std::string cheaper(const cases::Case& mill_case, double seconds);

}  // namespace mahlwerk::commands
