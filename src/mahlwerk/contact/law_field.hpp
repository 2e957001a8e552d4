// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

#include "mahlwerk/base/field.hpp"

// What a contact law tells of its own numbers: reader, writer and checks of cases walk over it.
namespace mahlwerk::contact {

/// A number of a law. At most one of `instead_of` and `default_text` says something; the number may
/// then be left out of a case, and is 0.
template <class L>
struct LawField : Field<L> {
  std::string_view instead_of = "";    ///< key of the number whose place this one takes
  std::string_view default_text = "";  ///< what the law takes where the case is silent, in words

  constexpr bool is_optional() const { return !instead_of.empty() || !default_text.empty(); }
};

/// Whether the number counts: it is not left out, and no other takes its place.
template <class L>
bool is_given(const L& law, const LawField<L>& field) {
  for (const LawField<L>& other : L::fields())
    if (other.instead_of == field.key && law.*other.value != 0) return false;
  return law.*field.value != 0 || !field.is_optional();
}

/// One of two words that a law takes.
template <class L>
struct LawSwitch {
  std::string_view key;
  std::array<std::string_view, 2> words;  ///< the first is the default
  bool L::*second;                        ///< whether the second is chosen
  std::string_view source;                ///< why the first is the default
};

}  // namespace mahlwerk::contact
