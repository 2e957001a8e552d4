// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/results/notices/notice_counts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace mahlwerk::results {
namespace {

Severity severity_of(const NoticeCount& one) {
  return one.first.severity;
}

}  // namespace

void count(NoticeCounts& counts, const Notices& of_run) {
  Notices once;
  merge(once, of_run);
  for (const Notice& one : once) {
    const auto known = std::ranges::find_if(
        counts, [&](const NoticeCount& c) { return c.first.code == one.code; });
    if (known == counts.end()) {
      counts.push_back({one, 1});
      continue;
    }
    ++known->runs;
    known->first.severity = std::max(known->first.severity, one.severity);
  }
}

void sort(NoticeCounts& counts) {
  std::ranges::stable_sort(counts, std::greater(), severity_of);
}

void merge(Notices& all, const Notices& more) {
  for (const Notice& one : more) {
    const auto known = std::ranges::find(all, one.code, &Notice::code);
    if (known == all.end())
      all.push_back(one);
    else
      known->severity = std::max(known->severity, one.severity);
  }
}

std::string warning_codes(const Notices& notices) {
  Notices once;
  merge(once, notices);
  std::string text;
  for (const Notice& one : once)
    if (one.warns()) text += (text.empty() ? "" : ";") + one.code;
  return text;
}

std::string sentence(const NoticeCount& one, std::size_t of, std::string_view what) {
  return fmt::format("{} of {} {}{}: {}: {}", one.runs, of, what, of == 1 ? "" : "s",
                     one.first.code, one.first.text);
}

}  // namespace mahlwerk::results
