// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/notice.hpp"

// The notices of many runs, counted by code.
namespace mahlwerk::results {

/// A code with the number of runs that have it.
struct NoticeCount {
  Notice first;  ///< of the first run that has the code, with the gravest severity of all
  std::size_t runs = 0;
};
/// The gravest first, then in the order of first mention.
using NoticeCounts = std::vector<NoticeCount>;

/// Adds the notices of one run; a code that the run has twice counts once.
void count(NoticeCounts& counts, const Notices& of_run);
void sort(NoticeCounts& counts);

/// One notice for each code of several runs of the same case: of the first, and the gravest.
void merge(Notices& all, const Notices& more);

/// The codes of warnings, each once, separated by ";": a cell of a table.
std::string warning_codes(const Notices& notices);

/// "3 of 40 points: long-contacts: The balls were ...".
std::string sentence(const NoticeCount& one, std::size_t of, std::string_view what);

}  // namespace mahlwerk::results
