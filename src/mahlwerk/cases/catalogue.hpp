// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

// Mills, jars, materials and ball sets: data only, one TOML file each, every value with its source.
namespace mahlwerk::cases {

/// One value as it stands in a catalogue file.
struct CatalogueValue {
  std::string text;         ///< as a case would say it: "70 mm", "1:-2", "0.35"
  std::string source;       ///< where it comes from, never empty
  bool unverified = false;  ///< confidence = "unverified" in the file
};

/// A statement in a file that must hold between its values and a figure known from elsewhere.
struct CatalogueCheck {
  std::string quantity;  ///< which derived quantity, one of check_quantities()
  double expected = 0;   ///< in the quantity's unit
  double tolerance = 0;  ///< relative
  std::string source;
};

struct CatalogueEntry {
  std::string category;  ///< "mills", "jars", "materials" or "media"
  std::string name;      ///< the file's stem, and the word in a case
  std::string title;     ///< what people call it
  std::string kind;      ///< motion of a mill, shape of a jar; empty otherwise
  std::string about;     ///< a sentence
  std::map<std::string, CatalogueValue> values;
  std::vector<std::string> jars;  ///< of a mill: names in jars that fit it
  std::vector<CatalogueCheck> checks;
  std::string file;
};

class Catalogue {
 public:
  static constexpr std::string_view categories[] = {"mills", "jars", "materials", "media"};

  /// `root` holds one folder per category. Throws InputError if it is not there.
  explicit Catalogue(std::filesystem::path root);

  std::vector<std::string> names(std::string_view category) const;  ///< sorted
  bool has(std::string_view category, std::string_view name) const;
  /// Throws InputError with the nearest names if there is no such entry, or naming what is wrong in
  /// its file. `where` is the place that asked for it.
  CatalogueEntry find(std::string_view category, std::string_view name,
                      std::string_view where = "") const;
  const std::filesystem::path& root() const { return root_; }

 private:
  std::filesystem::path root_;
};

/// The value of a derived quantity, in its unit, from an entry's values. Throws InputError for an
/// unknown quantity or a value it needs that is missing.
double derived(const CatalogueEntry& entry, std::string_view quantity);

/// Names, units and meanings of the quantities a [[check]] may name.
struct CheckQuantity {
  std::string_view name, unit, about;
};
const std::vector<CheckQuantity>& check_quantities();

/// The known word nearest to `word`, or empty if none is near.
std::string nearest_name(std::string_view word, const std::vector<std::string>& known);

}  // namespace mahlwerk::cases
