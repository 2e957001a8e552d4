// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace mahlwerk::contact {

/// Twisting friction: resistance to relative rotation about the normal. Its torque is in
/// soft/kernel/twisting_torque.hpp (dem.42 to dem.44).
enum class Twisting { none, marshall };

/// A twisting model in words.
struct TwistingRule {
  std::string_view name, about;
};

/// Register of the models, in the order of the enum Twisting.
inline constexpr std::array twisting_rules{
    TwistingRule{"none", "bodies turn freely about the normal"},
    TwistingRule{
        "marshall",
        "spring, dashpot and slider of the friction over the contact area (Marshall 2009)"}};

}  // namespace mahlwerk::contact
