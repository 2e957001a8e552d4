// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/files/json_value.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::results {

/// summary.json: every quantity an object under its plain name, and "_about" with what made them.
/// What is not a number is null.
std::string summary_json(const Outcome& outcome, std::string_view version);

/// A list of objects: code, severity, in how many runs, and the text of the first.
Json notices_json(const NoticeCounts& counts);

}  // namespace mahlwerk::results
