// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/printable.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace mahlwerk {
namespace {

unsigned byte(char c) {
  return static_cast<unsigned char>(c);
}

/// A UTF-8 character: code point and number of bytes; 0 bytes: invalid UTF-8.
struct Character {
  char32_t number = 0;
  std::size_t bytes = 0;
};

Character first_of(std::string_view text) {
  constexpr std::array<char32_t, 5> least{0, 0, 0x80, 0x800, 0x10000};  // else an overlong form
  const unsigned first = byte(text[0]);
  const std::size_t bytes = first < 0x80    ? 1
                            : first < 0xC0  ? 0
                            : first < 0xE0  ? 2
                            : first < 0xF0  ? 3
                            : first <= 0xF4 ? 4
                                            : 0;
  if (bytes == 0 || bytes > text.size()) return {};
  if (bytes == 1) return {first, 1};
  char32_t number = first & (0x7FU >> bytes);
  for (const char c : text.substr(1, bytes - 1)) {
    if ((byte(c) & 0xC0U) != 0x80) return {};
    number = number << 6U | (byte(c) & 0x3FU);
  }
  const bool surrogate = number >= 0xD800 && number < 0xE000;
  if (number < least[bytes] || number > 0x10FFFF || surrogate) return {};
  return {number, bytes};
}

/// False for control characters and for characters that XML does not allow.
bool is_shown(char32_t c) {
  if (c == '\t' || c == '\n') return true;
  return c >= 0x20 && !(c >= 0x7F && c < 0xA0) && c != 0xFFFE && c != 0xFFFF;
}

}  // namespace

std::string printable(std::string_view text) {
  std::string shown;
  shown.reserve(text.size());
  while (!text.empty()) {
    const Character c = first_of(text);
    const std::size_t bytes = c.bytes > 0 ? c.bytes : 1;
    if (c.bytes == 0)
      shown += fmt::format("\\x{:02x}", byte(text[0]));
    else if (is_shown(c.number))
      shown += text.substr(0, bytes);
    else
      shown += fmt::format("\\u{:04x}", static_cast<unsigned>(c.number));
    text.remove_prefix(bytes);
  }
  return shown;
}

bool has_control(std::string_view text) {
  return std::ranges::any_of(text, [](char c) { return byte(c) < 0x20 || byte(c) == 0x7F; });
}

}  // namespace mahlwerk
