// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace mahlwerk::report {

inline bool has(const std::string& text, std::string_view part) {
  return text.find(part) != std::string::npos;
}

/// A page without the scripts that the program brings.
inline std::string without_scripts(std::string html) {
  for (std::size_t at = html.find("<script>"); at != std::string::npos;
       at = html.find("<script>", at))
    html.erase(at, html.find("</script>", at) + 9 - at);
  return html;
}

/// Every tag that is opened is closed, in order. The content of scripts is no markup.
inline bool well_formed(const std::string& page) {
  const std::string html = without_scripts(page);
  std::vector<std::string> open;
  for (std::size_t at = html.find('<'); at != std::string::npos; at = html.find('<', at + 1)) {
    const std::size_t end = html.find('>', at);
    const std::string tag = html.substr(at + 1, html.find_first_of(" />\n", at + 2) - at - 1);
    if (html[at + 1] == '!' || tag == "meta" || html[end - 1] == '/') continue;
    if (html[at + 1] != '/') {
      open.push_back(tag);
    } else {
      if (open.empty() || open.back() != html.substr(at + 2, end - at - 2)) return false;
      open.pop_back();
    }
  }
  return open.empty();
}

inline std::size_t times(const std::string& text, std::string_view part) {
  std::size_t number = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++number;
  return number;
}

/// True if the text contains the parts in this order.
inline bool in_order(const std::string& text, const std::vector<std::string>& parts) {
  std::size_t at = 0;
  for (const std::string& part : parts) {
    at = text.find(part, at);
    if (at == std::string::npos) return false;
    at += part.size();
  }
  return true;
}

}  // namespace mahlwerk::report
