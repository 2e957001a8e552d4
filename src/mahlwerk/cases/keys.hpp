// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/field.hpp"

namespace mahlwerk::cases {

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
  /// Choices of the section under which the key has a meaning: key -> words. Empty: always.
  std::map<std::string, std::vector<std::string>> under;

  std::string_view name() const;  ///< without the section: "speed"
  bool operator==(const KeyInfo&) const;
};

/// Every key that a case may have under any model, in the order in which cases are written; without
/// the keys of [sweep], [optimise], [match], [fit] and [uncertainty].
const std::vector<KeyInfo>& all_keys();

/// The keys of a section, or those that only one of its kinds has.
struct KeySection {
  std::string section;  ///< "mill", "contact.pairs"; empty for the keys outside sections
  std::string kind;     ///< "planetary", "hertz-mindlin"; empty for the keys of every kind
  std::string choice;   ///< the key that chooses the kind: "mill.kind"; empty without kinds
  std::string about;    ///< description, one sentence
  std::vector<KeyInfo> keys;
};

/// All sections, each followed by its kinds. A key that every kind has stands with the section; if
/// its default depends on the kind, it stands with each kind, too. A key whose unit, range or
/// meaning depends on another choice stands once for each, with different `under`.
const std::vector<KeySection>& key_sections();

}  // namespace mahlwerk::cases
