// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

#include "mahlwerk/base/indirect.hpp"
#include "mahlwerk/contact/adhesion.hpp"

// A contact law chosen at run time, for those who do not look into it; contact/laws.hpp lists what
// it can be.
namespace mahlwerk::contact {

struct AnyLaw;

std::string_view name_of(const AnyLaw& law);  ///< "hertz-mindlin"
/// What its shortest_time() is of, as words: "the shortest collision".
std::string_view shortest_time_name(const AnyLaw& law);
/// What it knows of bodies that stick together; empty if nothing.
std::span<const AdhesionParameter> adhesion(const AnyLaw& law);

}  // namespace mahlwerk::contact
