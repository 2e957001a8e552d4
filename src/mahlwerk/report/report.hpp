// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/results/files/folder.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::report {

/// report.html of one result: what came out, how sure it is, and what it rests on.
/// Without `film` it has no replay, and is a seventh as large.
std::string report_page(const results::Outcome& outcome, std::string_view version,
                        bool film = true);

/// The result in a sentence: how often, how hard, how much.
std::string sentence(const results::Outcome& outcome);

/// Everything a result consists of: the files of results::write and report.html.
void write(const results::Folder& folder, const results::Outcome& outcome, std::string_view version,
           std::string_view below = "", bool film = true);

}  // namespace mahlwerk::report
