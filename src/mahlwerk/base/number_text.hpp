// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <charconv>
#include <limits>
#include <string_view>

namespace mahlwerk {

/// A text split into a leading number and the rest: "400 rpm" gives 400 and "rpm". A text without a
/// leading number gives NaN and the whole text. `rest` is valid as long as the text.
struct NumberText {
  double number = std::numeric_limits<double>::quiet_NaN();
  std::string_view rest;
};

inline NumberText number_text(std::string_view text) {
  double number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  if (read.ec != std::errc{}) return {.rest = text};
  std::string_view rest = text.substr(static_cast<std::size_t>(read.ptr - text.data()));
  rest.remove_prefix(std::min(rest.find_first_not_of(' '), rest.size()));
  return {number, rest};
}

}  // namespace mahlwerk
