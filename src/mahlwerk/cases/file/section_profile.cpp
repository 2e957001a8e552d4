// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/section_profile.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>

#include "mahlwerk/base/text.hpp"
#include "mahlwerk/cases/file/mesh_file.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::size_t most_corners = 1000;

std::optional<double> number(std::string_view cell) {
  cell = trimmed(cell);
  double value = 0;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  const bool whole = error == std::errc{} && end == cell.data() + cell.size();
  return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

}  // namespace

geometry::Section read_section_profile(std::string_view text, double scale) {
  geometry::Section section;
  bool header = false;
  constexpr std::string_view mark = "\xEF\xBB\xBF";  // of UTF-8, as tables of spreadsheets have it
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  for (std::size_t from = 0, line = 1; from < text.size(); ++line) {
    const std::size_t to = std::min(text.find('\n', from), text.size());
    const std::string_view row = trimmed(text.substr(from, to - from));
    from = to + 1;
    if (row.empty() || row.front() == '#') continue;
    if (!header) {
      if (row != "x,y") throw MeshFileError("the first line of a section must be \"x,y\"");
      header = true;
      continue;
    }
    const std::size_t comma = std::min(row.find(','), row.size());
    const auto x = number(row.substr(0, comma)),
               y = number(comma < row.size() ? row.substr(comma + 1) : "");
    if (!x || !y) throw MeshFileError(fmt::format("line {} is not a row of two numbers", line));
    section.push_back({scale * *x, scale * *y});
    if (section.size() > most_corners + 1)
      throw MeshFileError(fmt::format("the section has more than {} corners", most_corners));
  }
  if (section.size() > 1 && section.front() == section.back()) section.pop_back();
  if (section.size() > most_corners)
    throw MeshFileError(fmt::format("the section has more than {} corners", most_corners));
  if (const std::string flaw = geometry::flaw_of(section); !flaw.empty())
    throw MeshFileError("the section is no simple polygon: " + flaw);
  return section;
}

}  // namespace mahlwerk::cases
