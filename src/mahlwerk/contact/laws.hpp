// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>
#include <variant>

#include "mahlwerk/contact/laws/adams_impact.hpp"
#include "mahlwerk/contact/laws/hertz_mindlin.hpp"
#include "mahlwerk/contact/laws/hertz_tsuji.hpp"
#include "mahlwerk/contact/laws/jkr.hpp"
#include "mahlwerk/contact/laws/linear_spring.hpp"
#include "mahlwerk/contact/laws/sjkr.hpp"
#include "mahlwerk/contact/laws/walton_braun.hpp"

namespace mahlwerk::contact {

/// A list of contact laws; a type that lacks something of a Law is an error that says what.
template <Law... L>
using LawVariant = std::variant<L...>;

/// The register: every contact law there is. A new one is its file in laws/ and its name here. The
/// first is the default.
using AnyLaw =
    LawVariant<HertzMindlin, HertzTsuji, LinearSpring, AdamsImpact, WaltonBraun, Jkr, Sjkr>;

constexpr std::size_t laws_count = std::variant_size_v<AnyLaw>;

/// Every law of the register, with its default numbers.
inline std::array<AnyLaw, laws_count> all_laws() {
  return []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<AnyLaw, laws_count>{AnyLaw(std::in_place_index<i>)...};
  }
  (std::make_index_sequence<laws_count>());
}

/// "hertz-mindlin"
inline std::string_view name_of(const AnyLaw& law) {
  return std::visit([](const auto& l) { return l.name; }, law);
}

}  // namespace mahlwerk::contact
