// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// The 3-D replay as HTML section with its data and script (viewer/README.md). Empty if the outcome
/// has no replay frames.
std::string replay_section(const results::Outcome& outcome);

/// The data of the 3-D replay as JSON (viewer/README.md): jar, motion and the frames of `film`, of
/// which there is at least one.
std::string replay_data(const cases::Case& mill_case, const observe::Replay& film);

}  // namespace mahlwerk::report
