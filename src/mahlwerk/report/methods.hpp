// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// A methods paragraph for a paper. An asterisk marks every assumed value: a default that the case
/// does not give.
std::string methods(const results::Outcome& outcome, std::string_view version);

}  // namespace mahlwerk::report
