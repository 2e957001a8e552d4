// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/base/base64.hpp"

#include <cstddef>
#include <cstdint>

namespace mahlwerk {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = i; k < i + 3; ++k)
      three = three << 8 | (k < bytes.size() ? static_cast<unsigned char>(bytes[k]) : 0U);
    for (int k = 18; k >= 0; k -= 6) text += digits[three >> k & 63];
  }
  for (std::size_t k = bytes.size(); k % 3 != 0; ++k) text[text.size() - 3 + k % 3] = '=';
  return text;
}

}  // namespace mahlwerk
