// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"

// Descriptions of a law's parameters. The reader, the writer and the checks of cases iterate over
// them.
namespace mahlwerk::contact {

/// Parameter of a law. At most one of `instead_of` and `default_text` is not empty. The parameter
/// is then optional in a case, and 0 if left out.
template <class L>
struct LawField : Field<L> {
  std::string_view instead_of = "";    ///< key of the parameter that this one replaces
  std::string_view default_text = "";  ///< default of the law, in words

  constexpr bool is_optional() const { return !instead_of.empty() || !default_text.empty(); }
};

/// Whether the parameter is in effect: it is given or required, and no other parameter replaces it.
template <class L>
bool is_given(const L& law, const LawField<L>& field) {
  for (const LawField<L>& other : L::fields())
    if (other.instead_of == field.key && law.*other.value != 0) return false;
  return law.*field.value != 0 || !field.is_optional();
}

/// Option of a law with two values.
template <class L>
struct LawSwitch {
  std::string_view key;
  std::array<std::string_view, 2> words;  ///< the first is the default
  bool L::*second;                        ///< true if the second word is chosen
  std::string_view source;                ///< why the first is the default
  std::string_view about;
  std::array<std::string_view, 2> meanings;  ///< of the words
};

}  // namespace mahlwerk::contact
