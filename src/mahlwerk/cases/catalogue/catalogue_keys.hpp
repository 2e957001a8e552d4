// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/field.hpp"

// The keys that a catalogue file may contain, for the parser, `describe` and the tests.
namespace mahlwerk::cases {

/// Stands for the unit of a value that is not a number but the name of an entry in materials.
constexpr std::string_view a_material = "name of a material";
/// Stands for the unit of a value that is one of the words of jar_axis.
constexpr std::string_view an_axis = "\"vertical\" or \"horizontal\"";
constexpr bool is_number(std::string_view unit) {
  return unit != a_material && unit != an_axis;
}

/// A value that a file of some category and kind may give.
struct CatalogueKey {
  std::string key;
  std::string_view unit;  ///< as in Field, or `a_material` or `an_axis`
  Range range;            ///< in `unit`
  std::string about;
};

/// The words for `kind` in a file of this category: motions for mills, shapes for jars, none
/// otherwise.
std::vector<std::string> catalogue_kinds(std::string_view category);

/// All values that an entry may give: for a mill the fields of its motion, each also with _least
/// and _most for the range of the machine; for a jar the fields of its shape; and the keys that
/// all entries of the category have.
std::vector<CatalogueKey> catalogue_keys(std::string_view category, std::string_view kind);

/// The number in a value's text, in the key's unit; "1:-2" of a speed ratio is -2. Throws
/// UnitError. Not for words.
double number_of(std::string_view text, const CatalogueKey& key);

}  // namespace mahlwerk::cases
