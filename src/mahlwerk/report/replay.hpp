// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// The 3-D replay as part of a page: its section, its data and its script (viewer/README.md). Empty
/// where there is no film.
std::string replay_section(const results::Outcome& outcome);

/// viewer/dist/replay.js, which travels in the program.
std::string_view replay_script();

}  // namespace mahlwerk::report
