// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
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

/// The data of the pictures of a page, in their order.
inline std::vector<nlohmann::json> pictures_in(const std::string& page) {
  constexpr std::string_view head = "<script type=\"application/json\" class=\"picture\">";
  std::vector<nlohmann::json> list;
  for (std::size_t at = page.find(head); at != std::string::npos; at = page.find(head, at + 1)) {
    const std::size_t from = at + head.size();
    list.push_back(nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from)));
  }
  return list;
}

/// Kind and title of the pictures of a page: "map D50 (µm)".
inline std::vector<std::string> picture_names(const std::string& page) {
  std::vector<std::string> names;
  for (const nlohmann::json& one : pictures_in(page))
    names.push_back(one["kind"].get<std::string>() + " " + one["title"].get<std::string>());
  return names;
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
