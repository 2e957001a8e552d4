// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mahlwerk/base/field.hpp"

// What a catalogue file may say: read by the parser, by `describe`, and by the tests.
namespace mahlwerk::cases {

/// The unit of a value that is no number but the name of an entry in materials.
constexpr std::string_view a_material = "name of a material";

/// One value a file of some category and kind may give.
struct CatalogueKey {
  std::string key;
  std::string_view unit;  ///< as in Field, or `a_material`
  Range range;            ///< in `unit`
  std::string about;
};

/// Names a file of this category may give as `kind`: motions for mills, shapes for jars, none
/// otherwise.
std::vector<std::string> catalogue_kinds(std::string_view category);

/// Every value an entry may give. For a mill the fields of its motion, each also with _least and
/// _most, the range the machine offers; for a jar the fields of its shape; and what the category
/// adds to them.
std::vector<CatalogueKey> catalogue_keys(std::string_view category, std::string_view kind);

/// The number a value's text stands for, measured in the key's unit; "1:-2" of a speed ratio is -2.
/// Throws UnitError. Not for names of materials.
double number_of(std::string_view text, const CatalogueKey& key);

}  // namespace mahlwerk::cases
