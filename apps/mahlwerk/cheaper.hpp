// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <string>

#include "mahlwerk/cases/case.hpp"

namespace mahlwerk::app {

/// Keys that make a long run cheaper, each with the time that the run would then take: softening,
/// where contacts stay hard enough, and replicates. Empty for a run that is not long. `seconds`
/// estimates the time of all runs of a case on this machine.
std::string cheaper(const cases::Case& mill_case,
                    const std::function<double(const cases::Case&)>& seconds);

}  // namespace mahlwerk::app
