// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/file/section_reader.hpp"
#include "mahlwerk/cases/file/table.hpp"
#include "mahlwerk/cases/read.hpp"

namespace mahlwerk::cases {

/// The values of a case file before its sections are read: overrides replace them, [sweep] adds
/// some, formulas compute some. All faults go to `findings`.
class CaseTree {
 public:
  CaseTree(Node root, std::filesystem::path file, const Catalogue& catalogue);

  /// Puts the parts of a mill of the catalogue before those of the case. A part of the case that
  /// has the name of one of them gives only the keys that differ.
  void add_parts_of_mill(const std::vector<Override>& overrides);
  /// Puts the overrides of one source in their places.
  void apply(const std::vector<Override>& overrides, ValueSource source);
  /// A key without a value in the case gets the first value of its sweep. `locations`: of the keys
  /// of [sweep] in the file.
  void fill_from_sweep(const Sweep& sweep, const std::map<std::string, std::string>& locations);
  /// Evaluates the formulas of [sweep] and sets their keys.
  void apply_formulas(const Sweep& sweep, const std::map<std::string, std::string>& locations);
  /// The table of a section, or null. A value that is not a table is a fault, and so is a missing
  /// section that is `needed`.
  const Node* section(std::string_view name, bool needed = false);

  const Node& root() const { return root_; }
  const std::filesystem::path& file() const { return file_; }
  Findings findings;

 private:
  Node given(const Override& one) const;
  void remove(const std::string& key);
  Quantity derived(const Sweep& sweep, std::string_view key, std::size_t depth) const;

  Node root_;
  std::filesystem::path file_;
};

/// The section that varies a key, and what its keys are called in origins.
std::pair<std::string, std::string> section_of(ValueSource source);

}  // namespace mahlwerk::cases
