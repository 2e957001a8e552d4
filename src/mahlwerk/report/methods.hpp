// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// What was run, in a paragraph to paste into a paper. An asterisk follows every value that the
/// case did not give and nobody measured.
std::string methods(const results::Outcome& outcome, std::string_view version);

}  // namespace mahlwerk::report
