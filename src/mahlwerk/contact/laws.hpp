// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <variant>

#include "mahlwerk/contact/adams_impact.hpp"
#include "mahlwerk/contact/hertz_mindlin.hpp"
#include "mahlwerk/contact/hertz_tsuji.hpp"
#include "mahlwerk/contact/jkr.hpp"
#include "mahlwerk/contact/linear_spring.hpp"
#include "mahlwerk/contact/sjkr.hpp"
#include "mahlwerk/contact/walton_braun.hpp"

namespace mahlwerk::contact {

/// The register: every contact law there is, in the order of LawName.
using AnyLaw =
    std::variant<HertzMindlin, HertzTsuji, LinearSpring, AdamsImpact, WaltonBraun, Jkr, Sjkr>;

inline AnyLaw law(const LawChoice& choice) {
  switch (choice.law) {
    case LawName::hertz_mindlin:
      return HertzMindlin(choice);
    case LawName::hertz_tsuji:
      return HertzTsuji(choice);
    case LawName::linear_spring:
      return LinearSpring(choice);
    case LawName::adams_impact:
      return AdamsImpact(choice);
    case LawName::walton_braun:
      return WaltonBraun(choice);
    case LawName::jkr:
      return Jkr(choice);
    case LawName::sjkr:
      return Sjkr(choice);
  }
  return HertzMindlin(choice);
}

}  // namespace mahlwerk::contact
