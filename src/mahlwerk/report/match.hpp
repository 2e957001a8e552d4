// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/campaign/search/match.hpp"
#include "mahlwerk/report/optimum.hpp"

// Result of matching mill B to mill A: text for the terminal and page.
namespace mahlwerk::report {

using campaign::MatchResult;

std::vector<std::string> sentences(const MatchResult& found);
std::string match_table(const MatchResult& found);  ///< for the terminal
std::string match_page(const MatchResult& found, std::string_view version);
Plot match_plot(const MatchResult& found);  ///< power spectra of both mills

}  // namespace mahlwerk::report
