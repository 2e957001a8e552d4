// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "mahlwerk/base/indirect.hpp"
#include "mahlwerk/contact/adhesion.hpp"

// A contact law chosen at run time, as an incomplete type. Code that needs the alternatives
// includes contact/laws.hpp, which lists them.
namespace mahlwerk::contact {

struct AnyLaw;

std::string_view name_of(const AnyLaw& law);  ///< for instance "hertz-mindlin"
/// What the law's shortest_time() is the time of, in words: "the shortest collision".
std::string_view shortest_time_name(const AnyLaw& law);
/// The adhesion parameters that the law reads; empty if none.
std::span<const AdhesionParameter> adhesion(const AnyLaw& law);

}  // namespace mahlwerk::contact
