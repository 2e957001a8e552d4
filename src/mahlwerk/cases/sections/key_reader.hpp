// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/cases/sweep.hpp"

namespace mahlwerk::cases {

/// Reads the dotted keys of one section, each with a list, a range or a formula.
class KeyReader {
 public:
  using Locations = std::map<std::string, std::string>;

  KeyReader(std::string section, Locations& locations, Findings& findings)
      : section_(std::move(section)), locations_(locations), findings_(findings) {}

  /// Reads the keys of `table`, except those in `own`: settings of the section itself.
  void read(const Node& table, const std::set<std::string_view>& own = {});

  std::vector<SweptKey> keys() { return std::move(keys_); }
  std::map<std::string, std::string> derived() { return std::move(derived_); }

 private:
  void fault(const Node& at, std::string what, std::string remedy, const char* code);
  void read_key(const std::string& key, const Node& node);
  void read_range(const std::string& key, const Node& node);
  void read_list(const std::string& key, const Node& node);

  std::string section_;
  Locations& locations_;
  Findings& findings_;
  std::vector<SweptKey> keys_;
  std::map<std::string, std::string> derived_;
};

/// Stands for any key of the case, as a key of a section about many runs.
constexpr std::string_view any_key = "KEY";

/// The values of a key, and a list of words in quotes, as written in a case file.
std::string values_text(const SweptKey& key);
std::string list_text(const std::vector<std::string>& words);

}  // namespace mahlwerk::cases
