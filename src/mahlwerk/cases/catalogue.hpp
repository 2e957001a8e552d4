// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The catalogue of mills, jars, materials and ball sets: one TOML file each, every value with its
// source.
namespace mahlwerk::cases {

/// One value of a catalogue file.
struct CatalogueValue {
  std::string text;         ///< as written in a case: "70 mm", "1:-2", "0.35"
  std::string source;       ///< citation, never empty
  bool unverified = false;  ///< confidence = "unverified" in the file
  bool assumed = false;     ///< confidence = "assumed": not known of this entry
  /// `from` and `to`: the plausible range of an assumed value, or the 95 % interval of a measured
  /// one (confidence = "measured"); else empty.
  std::array<std::string, 2> range = {};
};

/// A [[check]] of a catalogue file: a published value that a quantity derived from the entry's
/// values must reproduce.
struct CatalogueCheck {
  std::string quantity;  ///< name of the derived quantity, one of check_quantities()
  double expected = 0;   ///< in the quantity's unit
  double tolerance = 0;  ///< relative
  std::string source;
};

/// A [[parts]] of a mill: its keys as a case would give them, with one source for all.
struct CataloguePart {
  std::vector<std::pair<std::string, std::string>> keys;  ///< each with its value as TOML
  std::string source;                                     ///< citation, never empty
  bool unverified = false, assumed = false;               ///< as of a CatalogueValue
  bool operator==(const CataloguePart&) const = default;
};

struct CatalogueEntry {
  std::string category;            ///< "mills", "jars", "materials" or "media"
  std::string name;                ///< the file's stem; a case uses this name
  std::string title;               ///< usual name
  std::vector<std::string> names;  ///< other names that people write, "MM 400"
  std::string kind;                ///< motion of a mill, shape of a jar; empty otherwise
  std::string about;               ///< description, one sentence
  std::map<std::string, CatalogueValue> values;
  std::vector<std::string> jars;     ///< of a mill: names of the catalogue's jars that fit it
  std::vector<CataloguePart> parts;  ///< of a mill: its parts in the jar
  std::vector<CatalogueCheck> checks;
  std::string file;
};

class Catalogue {
 public:
  static constexpr std::string_view categories[] = {"mills", "jars", "materials", "media"};

  /// `root` holds one folder per category. Throws InputError if there is none.
  explicit Catalogue(std::filesystem::path root);

  std::vector<std::string> names(std::string_view category) const;  ///< sorted
  bool has(std::string_view category, std::string_view name) const;
  /// Names of the entries that a word may mean: their name, title or one of their other names,
  /// compared without case, blanks and punctuation. An entry of exactly this name is the only one.
  std::vector<std::string> entries_called(std::string_view category, std::string_view word) const;
  /// Reads the entry of a name that entries_called() knows. Throws InputError with the nearest
  /// names if there is no such entry or several, or with the faults of its file. `where` is the
  /// place that the error cites.
  CatalogueEntry find(std::string_view category, std::string_view name,
                      std::string_view where = "") const;
  const std::filesystem::path& root() const { return root_; }

 private:
  std::filesystem::path root_;
};

/// The value of a derived quantity, in its unit, from an entry's values. Throws InputError if the
/// quantity is unknown or a value needed for it is missing.
double derived(const CatalogueEntry& entry, std::string_view quantity);

/// Name, unit and meaning of a quantity that a [[check]] may name.
struct CheckQuantity {
  std::string_view name, unit, about;
};
const std::vector<CheckQuantity>& check_quantities();

/// The name in `known` nearest to `word`; empty if none is near.
std::string nearest_name(std::string_view word, const std::vector<std::string>& known);

}  // namespace mahlwerk::cases
