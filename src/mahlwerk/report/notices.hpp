// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

#include "mahlwerk/results/notices/notice_counts.hpp"

// Text of notices of many runs, counted by code. `of` is the number of runs, `what` the name of
// one: "point", "setting".
namespace mahlwerk::report {

/// For the terminal: a line for each warning code, with line end; empty if there is none.
std::string notice_lines(const results::NoticeCounts& counts, std::size_t of,
                         std::string_view what);

/// For a page: a box of warnings and a box of notes, each omitted if there is none.
std::string notice_boxes(const results::NoticeCounts& counts, std::size_t of,
                         std::string_view what);

}  // namespace mahlwerk::report
