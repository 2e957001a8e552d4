// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

// The scripts of pages, which travel in the program.
namespace mahlwerk::report {

/// The contents of viewer/dist/replay.js.
std::string_view replay_script();

/// The contents of web/dist/plots.js.
std::string_view plots_script();

}  // namespace mahlwerk::report
