// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/cases/file/stl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>

#include "mahlwerk/cases/file/mesh_file.hpp"

namespace mahlwerk::cases {
namespace {

constexpr std::size_t head = 84, record = 50;  // [bytes] header of a binary file, and a triangle

/// A little-endian 32-bit integer.
std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t n = 0;
  for (std::size_t k = 4; k-- > 0;) n = n << 8 | static_cast<unsigned char>(bytes[at + k]);
  return n;
}

void refuse_too_many(std::size_t triangles) {
  if (triangles > max_triangles)
    throw MeshFileError(
        fmt::format("it has {} triangles, more than the limit of {}", triangles, max_triangles));
}

std::vector<geometry::Corners> read_binary(std::string_view bytes, double scale) {
  const std::size_t count = number_at(bytes, 80);
  refuse_too_many(count);
  std::vector<geometry::Corners> all(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::size_t at = head + record * i + 12;  // after the normal
    const auto next = [&] {
      const double x = std::bit_cast<float>(number_at(bytes, at));
      at += 4;
      if (!std::isfinite(x))
        throw MeshFileError(
            fmt::format("triangle {} has a coordinate that is not a number", i + 1));
      return x * scale;
    };
    for (Vec3& corner : all[i]) {
      corner.x = next();
      corner.y = next();
      corner.z = next();
    }
  }
  return all;
}

/// Splits an ASCII STL into words, and counts lines.
class StlTokens {
 public:
  explicit StlTokens(std::string_view text) : text_(text) {}

  std::string_view next() {
    while (at_ < text_.size() && blank(text_[at_])) line_ += text_[at_++] == '\n' ? 1 : 0;
    const std::size_t from = at_;
    while (at_ < text_.size() && !blank(text_[at_])) ++at_;
    return text_.substr(from, at_ - from);
  }
  double number() {
    std::string_view word = next();
    const std::string_view said = word;
    if (word.starts_with('+')) word.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      throw MeshFileError(said.empty() ? fmt::format("it is cut off in line {}", line_)
                                       : fmt::format("\"{}\" in line {} is not a number",
                                                     said.substr(0, 40), line_));
    return value;
  }
  std::size_t line() const { return line_; }

 private:
  static bool blank(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1;
};

bool equals_ignoring_case(std::string_view word, std::string_view lower) {
  return std::ranges::equal(
      word, lower, [](char a, char b) { return std::tolower(static_cast<unsigned char>(a)) == b; });
}

std::vector<geometry::Corners> read_as_text(std::string_view text, double scale) {
  std::vector<geometry::Corners> all;
  geometry::Corners corners;
  std::size_t known = 0;
  bool ended = false;
  StlTokens words(text);
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (equals_ignoring_case(word, "vertex")) {
      if (known == 3)
        throw MeshFileError(
            fmt::format("the facet in line {} has more than three corners", words.line()));
      Vec3& c = corners[known++];
      c.x = scale * words.number();
      c.y = scale * words.number();
      c.z = scale * words.number();
    } else if (equals_ignoring_case(word, "endfacet")) {
      if (known != 3)
        throw MeshFileError(
            fmt::format("the facet that ends in line {} has {} corners", words.line(), known));
      all.push_back(corners);
      known = 0;
      refuse_too_many(all.size());
    }
    ended = ended || equals_ignoring_case(word, "endsolid");
  }
  if (!ended || known != 0)
    throw MeshFileError(
        fmt::format("it is cut off after triangle {}: there is no \"endsolid\"", all.size()));
  return all;
}

bool looks_like_text(std::string_view bytes) {
  StlTokens words(bytes.substr(0, 4096));
  if (!equals_ignoring_case(words.next(), "solid")) return false;
  for (std::string_view word = words.next(); !word.empty(); word = words.next())
    if (equals_ignoring_case(word, "facet") || equals_ignoring_case(word, "endsolid")) return true;
  return false;
}

}  // namespace

std::vector<geometry::Corners> read_stl(std::string_view bytes, double scale) {
  const bool has_head = bytes.size() >= head;
  const std::size_t whole = has_head ? head + record * number_at(bytes, 80) : 0;
  std::vector<geometry::Corners> all;
  if (has_head && bytes.size() == whole)
    all = read_binary(bytes, scale);
  else if (looks_like_text(bytes))
    all = read_as_text(bytes, scale);
  else if (whole > bytes.size())
    throw MeshFileError(fmt::format("its header gives {} triangles, and it ends in triangle {}",
                                    number_at(bytes, 80), (bytes.size() - head) / record + 1));
  else
    throw MeshFileError(
        "it is not an STL file: neither the length of a binary one nor the words of an ASCII one "
        "(OBJ files are known by their ending .obj, PLY files by their first word)");
  return all;
}

std::string stl_text(const geometry::Surface& surface) {
  std::string text = "solid jar\n";
  for (const auto& triangle : surface.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::int32_t i : triangle) {
      const Vec3& p = surface.points[static_cast<std::size_t>(i)];
      text += fmt::format("vertex {} {} {}\n", p.x, p.y, p.z);
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid jar\n";
}

}  // namespace mahlwerk::cases
