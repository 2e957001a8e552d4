// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

// The contact laws of the soft engine by name: what a case may ask for.
namespace mahlwerk::contact {

/// The normal and tangential law of a contact, in the order of `law_words`.
enum class LawName {
  hertz_mindlin,
  hertz_tsuji,
  linear_spring,
  adams_impact,
  walton_braun,
  jkr,
  sjkr
};
constexpr std::array<std::string_view, 7> law_words{
    "hertz-mindlin", "hertz-tsuji", "linear-spring", "adams-impact", "walton-braun", "jkr", "sjkr"};

/// Rolling resistance, in the order of `rolling_words`: none; constant torque against the rolling
/// (type A); viscous torque (type B); elastic-plastic spring and dashpot (type C).
enum class Rolling { none, cdt, viscous, epsd };
constexpr std::array<std::string_view, 4> rolling_words{"none", "cdt", "viscous", "epsd"};

/// What the laws need besides the properties of a pair.
struct LawChoice {
  LawName law = LawName::hertz_mindlin;
  Rolling rolling = Rolling::cdt;
  double rolling_damping = 0.2;  ///< [1] eta_r of epsd, share of critical damping
  bool curved_walls = false;     ///< R* of a ball at a wall takes the wall's curvature in
  bool rescaled_unloading =
      false;                   ///< the tangential spring gives way as a contact unloads (dem.21)
  double stiffness_speed = 1;  ///< [m/s] linear-spring, walton-braun: where k equals Hertz's
  double stiffness = 0;        ///< [N/m] k itself, of those two; 0: from stiffness_speed
  bool published_damping = false;  ///< adams-impact: the paper's damping (dem.15) instead of exact
  double damping_depth = 0;        ///< [m] adams-impact: d; 0: a hundredth of the largest overlap
  bool operator==(const LawChoice&) const = default;
};

}  // namespace mahlwerk::contact
