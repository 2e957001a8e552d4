// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <type_traits>
#include <variant>

#include "mahlwerk/contact/any_law.hpp"
#include "mahlwerk/contact/laws/adams_impact.hpp"
#include "mahlwerk/contact/laws/hertz_mindlin.hpp"
#include "mahlwerk/contact/laws/hertz_tsuji.hpp"
#include "mahlwerk/contact/laws/jkr.hpp"
#include "mahlwerk/contact/laws/linear_spring.hpp"
#include "mahlwerk/contact/laws/sjkr.hpp"
#include "mahlwerk/contact/laws/walton_braun.hpp"

namespace mahlwerk::contact {

/// L itself, where it is a Law; else an error that says what it lacks.
template <Law L>
using Checked = L;

/// A list of contact laws.
template <class... L>
using LawVariant = std::variant<Checked<L>...>;

/// The register: every contact law there is. A new one is its file in laws/ and its name here. The
/// first is the default.
using Laws =
    LawVariant<HertzMindlin, HertzTsuji, LinearSpring, AdamsImpact, WaltonBraun, Jkr, Sjkr>;
/// A class of its own, so that any_law.hpp can name it.
struct AnyLaw : Laws {
  using Models = Laws;
  using Models::Models;
};

constexpr std::size_t laws_count = std::variant_size_v<Laws>;

template <class... L>
std::array<AnyLaw, sizeof...(L)> default_laws(std::type_identity<std::variant<L...>>) {
  return {L{}...};
}
/// Every law of the register, with its default numbers.
inline std::array<AnyLaw, laws_count> all_laws() {
  return default_laws(std::type_identity<Laws>{});
}

}  // namespace mahlwerk::contact
