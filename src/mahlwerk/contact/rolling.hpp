// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

namespace mahlwerk::contact {

/// Rolling resistance models; soft/kernel/contact_force.hpp has the torques (dem.22 to dem.25,
/// dem.38).
enum class Rolling { none, cdt, viscous, epsd, own_spin };

/// Properties of a rolling resistance model, except its torque.
struct RollingRule {
  Rolling rule;
  std::string_view name, about;
  bool resists;
  std::string_view friction_unit;  ///< of the pairs' rolling_friction
  bool damped;                     ///< reads rolling_damping
  bool has_history;                ///< contacts store a rolling spring
  bool opposite;                   ///< the torques of both bodies are opposite, as Newton's are
};

/// Register of the models, in the order of the enum Rolling.
constexpr std::array rolling_rules{
    RollingRule{Rolling::none, "none", "balls roll freely", false, "", false, false, true},
    RollingRule{Rolling::cdt, "cdt", "constant torque against the rolling (type A)", true, "",
                false, false, true},
    RollingRule{Rolling::viscous, "viscous", "torque proportional to the rolling speed (type B)",
                true, "s/m", false, false, true},
    RollingRule{Rolling::epsd, "epsd", "elastic-plastic spring and dashpot (type C)", true, "",
                true, true, true},
    RollingRule{Rolling::own_spin, "own-spin",
                "constant torque against the spin of each ball in the laboratory (EDEM, eq. 11 of "
                "Mhadhbi 2021)",
                true, "", false, false, false}};
constexpr const RollingRule& rule_of(Rolling rolling) {
  return rolling_rules[static_cast<std::size_t>(rolling)];
}
static_assert(std::ranges::all_of(rolling_rules,
                                  [](const auto& r) { return &rule_of(r.rule) == &r; }),
              "rolling_rules stand in the order of Rolling");

}  // namespace mahlwerk::contact
