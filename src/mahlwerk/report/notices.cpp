// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/notices.hpp"

#include <fmt/format.h>

#include "mahlwerk/report/text/readable.hpp"

namespace mahlwerk::report {

std::string notice_lines(const results::NoticeCounts& counts, std::size_t of,
                         std::string_view what) {
  std::string text;
  for (const results::NoticeCount& one : counts)
    if (one.first.warns()) text += fmt::format("Warning: {}\n", results::sentence(one, of, what));
  return text;
}

std::string notice_boxes(const results::NoticeCounts& counts, std::size_t of,
                         std::string_view what) {
  std::string warnings, notes;
  for (const results::NoticeCount& one : counts)
    (one.first.warns() ? warnings : notes) +=
        fmt::format("<p>{}</p>\n", escaped(results::sentence(one, of, what)));
  std::string text;
  if (!warnings.empty())
    text += fmt::format("<section class=\"box warn\"><h2>Warnings</h2>\n{}</section>\n", warnings);
  if (!notes.empty())
    text += fmt::format("<section class=\"box\"><h2>Notes</h2>\n{}</section>\n", notes);
  return text;
}

}  // namespace mahlwerk::report
