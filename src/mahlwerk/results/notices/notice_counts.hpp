// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/notice.hpp"

// Notices of many runs, counted by code.
namespace mahlwerk::results {

/// A code with the number of runs that have it.
struct NoticeCount {
  Notice first;  ///< notice of the first run with this code, at the highest severity of all runs
  std::size_t runs = 0;
};
/// After `sort`: highest severity first, then in order of first occurrence.
using NoticeCounts = std::vector<NoticeCount>;

/// Adds the notices of one run; a code that the run has twice counts once.
void count(NoticeCounts& counts, const Notices& of_run);
void sort(NoticeCounts& counts);

/// Merges notices of several runs of the same case: one notice for each code, with the first text
/// and the highest severity.
void merge(Notices& all, const Notices& more);

/// The codes of warnings, each once, separated by ";": a cell of a table.
std::string warning_codes(const Notices& notices);

/// "3 of 40 points: long-contacts: The balls were ...".
std::string sentence(const NoticeCount& one, std::size_t of, std::string_view what);

}  // namespace mahlwerk::results
