// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace mahlwerk {

/// Severity of a notice, for readers of the results.
enum class Severity {
  note,     ///< how the run was computed
  warning,  ///< use the results with care
  invalid   ///< the results are outside the validity of the engine that ran
};

constexpr std::array<std::string_view, 3> severity_names{"note", "warning", "invalid"};
constexpr std::string_view name_of(Severity severity) {
  return severity_names[static_cast<std::size_t>(severity)];
}

constexpr Severity severity_of(std::string_view name) {
  const auto at = std::ranges::find(severity_names, name);
  return at == severity_names.end() ? Severity::warning
                                    : static_cast<Severity>(at - severity_names.begin());
}

/// A note or warning that accompanies the results of a run.
struct Notice {
  std::string code;  ///< heading in docs/warnings.md, for instance "not-settled"
  Severity severity = Severity::note;
  std::string text;  ///< one or more sentences

  bool warns() const { return severity != Severity::note; }
  bool operator==(const Notice&) const = default;
};
using Notices = std::vector<Notice>;

inline Notice note(std::string code, std::string text) {
  return {std::move(code), Severity::note, std::move(text)};
}
inline Notice warning(std::string code, std::string text) {
  return {std::move(code), Severity::warning, std::move(text)};
}
inline Notice invalid(std::string code, std::string text) {
  return {std::move(code), Severity::invalid, std::move(text)};
}

inline void append(Notices& all, Notices more) {
  for (Notice& one : more) all.push_back(std::move(one));
}

}  // namespace mahlwerk
