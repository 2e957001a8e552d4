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

/// The content of summary.json.
Json summary_of(const Outcome& outcome, std::string_view version);
/// Text of summary.json: an object for each quantity under its name, and "_about" with the case and
/// the program. NaN is null.
std::string summary_json(const Outcome& outcome, std::string_view version);

/// A list of objects: code, severity, number of runs, and the text of the first notice.
Json notices_json(const NoticeCounts& counts);
/// The notices of one run.
Json notices_json(const Notices& notices);

}  // namespace mahlwerk::results
