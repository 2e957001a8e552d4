// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// The powder sections of a report (HTML): capture, fineness, dose. Empty without [capture],
/// [grinding] and [kinetics].
std::string powder_sections(const results::Outcome& outcome);

}  // namespace mahlwerk::report
