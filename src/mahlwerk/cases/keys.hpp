// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/field.hpp"

namespace mahlwerk::cases {

/// A section of a case, with the key that chooses its kind.
struct SectionSpec {
  std::string_view name, choice, about;  ///< without a name: the keys outside sections
  bool many_runs = false;                ///< whether it is about many runs
  bool several = false;                  ///< whether a case may have several: [[balls]]
};

/// The sections of a case, in the order in which cases are written.
std::span<const SectionSpec> section_list();

/// A key of a case file.
struct KeyInfo {
  std::string key;   ///< "mill.speed"; in lists without index: "balls.diameter"
  std::string type;  ///< "number", "integer", "flag", "word", "text", "list" or "table"
  std::string unit;  ///< of a number; empty for a pure number
  Range range;       ///< of a number or integer, in `unit`
  std::vector<std::string> words;     ///< the words that the key takes, if it takes words
  std::vector<std::string> meanings;  ///< of the words, in their order; empty if words say it all
  std::string about;                  ///< description, one sentence
  /// The default as written in a case, and where it comes from. A default that follows from other
  /// values is only described, in `default_source`.
  std::string default_value, default_source;
  bool required = false;   ///< a case must give the key, or one that it may give instead of it
  std::string instead_of;  ///< the key that this one replaces: "jar.height" for "jar.volume"
  std::string label;       ///< name on an axis and in a form: "vibration frequency"
  std::string symbol;      ///< in the texts of plots: "$f$"; may be empty
  std::string start;       ///< value of a new case if neither user nor catalogue gives one
  UsualRange usual;        ///< usual values; empty: not known
  /// Plausible magnitudes of a number, in `unit`; 0 and infinity if there is no end. A value beyond
  /// them gets a warning.
  std::array<double, 2> plausible{0, std::numeric_limits<double>::infinity()};
  std::vector<std::string> engines;  ///< those that read the value, by name; "auto" is not named
  /// Choices of the section under which the key has a meaning: key -> words. Empty: always.
  std::map<std::string, std::vector<std::string>> under;

  std::string_view name() const;  ///< without the section: "speed"
  bool operator==(const KeyInfo&) const;
};

/// Every key that a case may have under any model, in the order in which cases are written; without
/// the keys of [sweep], [optimise], [match], [fit] and [uncertainty].
const std::vector<KeyInfo>& all_keys();
/// The key of this name, in lists with or without index; null if there is none. A key that several
/// kinds have is described as for the first of them.
const KeyInfo* find_key(std::string_view dotted);

/// The keys of a section, or those that only one of its kinds has.
struct KeySection {
  std::string section;   ///< "mill", "contact.pairs"; empty for the keys outside sections
  std::string kind;      ///< "planetary", "hertz-mindlin"; empty for the keys of every kind
  std::string choice;    ///< the key that chooses the kind: "mill.kind"; empty without kinds
  std::string about;     ///< description, one sentence
  bool several = false;  ///< whether a case may have several such sections
  std::vector<KeyInfo> keys;
};

/// All sections, each followed by its kinds. A key that every kind has stands with the section; if
/// its default depends on the kind, it stands with each kind, too. A key whose unit, range or
/// meaning depends on another choice stands once for each, with different `under`.
const std::vector<KeySection>& key_sections();

}  // namespace mahlwerk::cases
