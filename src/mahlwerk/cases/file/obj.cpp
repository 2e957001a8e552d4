// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "mahlwerk/base/text.hpp"
#include "mahlwerk/cases/file/mesh_file.hpp"

namespace mahlwerk::cases {
namespace {

/// The lines of an OBJ file. A backslash at the end of a line continues it.
class ObjLines {
 public:
  explicit ObjLines(std::string_view text) : text_(text) {}

  bool next() {
    line_.clear();
    if (at_ >= text_.size()) return false;
    for (bool more = true; more && at_ < text_.size();) {
      const std::size_t end = std::min(text_.find('\n', at_), text_.size());
      std::string_view part = trimmed(text_.substr(at_, end - at_));
      at_ = end + 1;
      ++number_;
      more = part.ends_with('\\');
      if (more) part.remove_suffix(1);
      line_ += part;
      line_ += ' ';
    }
    left_ = line_;
    return true;
  }
  std::string_view word() {
    left_ = trimmed(left_);
    const std::size_t end = std::min(left_.find_first_of(" \t"), left_.size());
    const std::string_view found = left_.substr(0, end);
    left_.remove_prefix(end);
    return found;
  }
  double number() {
    std::string_view said = word();
    if (said.starts_with('+')) said.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(said.data(), said.data() + said.size(), value);
    if (error != std::errc{} || end != said.data() + said.size() || !std::isfinite(value))
      throw MeshFileError(
          fmt::format("\"{}\" in line {} is not a number", said.substr(0, 40), number_));
    return value;
  }
  std::size_t line_number() const { return number_; }

 private:
  std::string_view text_, left_;
  std::string line_;
  std::size_t at_ = 0, number_ = 0;
};

/// The number of a corner from 0: "7", "7/1", "7/1/3", "7//3"; a negative one counts back from the
/// last vertex.
std::int64_t corner_number(std::string_view word, std::size_t vertices, std::size_t line) {
  const std::string_view first = word.substr(0, word.find('/'));
  std::int64_t n = 0;
  const auto [end, error] = std::from_chars(first.data(), first.data() + first.size(), n);
  if (error != std::errc{} || end != first.data() + first.size() || n == 0)
    throw MeshFileError(
        fmt::format("\"{}\" in line {} is not the number of a vertex", word.substr(0, 40), line));
  return n > 0 ? n - 1 : static_cast<std::int64_t>(vertices) + n;
}

}  // namespace

std::vector<geometry::Corners> read_obj(std::string_view text, double scale) {
  PolygonList polygons(scale);
  ObjLines lines(text);
  std::vector<std::int64_t> corners;
  while (lines.next()) {
    const std::string_view kind = lines.word();
    if (kind == "v") {
      const double x = lines.number(), y = lines.number(), z = lines.number();
      polygons.add_vertex(x, y, z);
    } else if (kind == "f") {
      corners.clear();
      for (std::string_view word = lines.word(); !word.empty() && !word.starts_with('#');
           word = lines.word())
        corners.push_back(corner_number(word, polygons.vertices(), lines.line_number()));
      polygons.add_polygon(corners, fmt::format("the face in line {}", lines.line_number()));
    }
  }
  return std::move(polygons).triangles();
}

}  // namespace mahlwerk::cases
