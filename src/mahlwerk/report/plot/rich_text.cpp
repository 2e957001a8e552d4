// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/plot/rich_text.hpp"

namespace mahlwerk::report {

std::string plain_text(std::string_view text) {
  std::string plain;
  bool symbol = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool shifts = (text[i] == '_' || text[i] == '^') && text.substr(i + 1).starts_with('{');
    const std::size_t end = shifts ? text.find('}', i) : std::string_view::npos;
    if (end != std::string_view::npos) {
      plain += text.substr(i + 2, end - i - 2);
      i = end;
    } else if (text[i] == '$' && (symbol || text.find('$', i + 1) != std::string_view::npos)) {
      symbol = !symbol;
    } else {
      plain += text[i];
    }
  }
  return plain;
}

}  // namespace mahlwerk::report
