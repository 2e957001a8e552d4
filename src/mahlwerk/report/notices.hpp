// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/notices/notice_counts.hpp"

// Notices of many runs, counted by code, as pages and terminals show them. `what` is the name of
// one of the `of` runs: "point", "setting".
namespace mahlwerk::report {

/// For the terminal: a line with its end for each code of a warning; empty if there is none.
std::string notice_lines(const results::NoticeCounts& counts, std::size_t of,
                         std::string_view what);

/// For a page: a box of warnings and a box of notes, each empty if there is none.
std::string notice_boxes(const results::NoticeCounts& counts, std::size_t of,
                         std::string_view what);

}  // namespace mahlwerk::report
