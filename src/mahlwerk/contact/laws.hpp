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
#include "mahlwerk/contact/laws/capillary.hpp"
#include "mahlwerk/contact/laws/hertz_mindlin.hpp"
#include "mahlwerk/contact/laws/hertz_tsuji.hpp"
#include "mahlwerk/contact/laws/jkr.hpp"
#include "mahlwerk/contact/laws/linear_spring.hpp"
#include "mahlwerk/contact/laws/sjkr.hpp"
#include "mahlwerk/contact/laws/thornton_ning.hpp"
#include "mahlwerk/contact/laws/walton_braun.hpp"

namespace mahlwerk::contact {

/// L itself if L satisfies Law; otherwise a compile error that names the missing requirement.
template <Law L>
using Checked = L;

/// A list of contact laws.
template <class... L>
using LawVariant = std::variant<Checked<L>...>;

/// Register of all contact laws. To add a law, add a file to laws/ and its name here. The first is
/// the default.
using Laws = LawVariant<HertzMindlin, HertzTsuji, LinearSpring, AdamsImpact, WaltonBraun, Jkr, Sjkr,
                        ThorntonNing, Capillary>;
/// A class, not an alias, so that any_law.hpp can declare it.
struct AnyLaw : Laws {
  using Models = Laws;
  using Models::Models;
};

constexpr std::size_t laws_count = std::variant_size_v<Laws>;

template <class... L>
std::array<AnyLaw, sizeof...(L)> default_laws(std::type_identity<std::variant<L...>>) {
  return {L{}...};
}
/// Every law of the register, with its default parameters.
inline std::array<AnyLaw, laws_count> all_laws() {
  return default_laws(std::type_identity<Laws>{});
}

}  // namespace mahlwerk::contact
