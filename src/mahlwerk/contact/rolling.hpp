// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <string_view>

namespace mahlwerk::contact {

/// Rolling resistance, in the order of `rolling_words`: none; constant torque against the rolling
/// (type A); viscous torque (type B); elastic-plastic spring and dashpot (type C).
enum class Rolling { none, cdt, viscous, epsd };
constexpr std::array<std::string_view, 4> rolling_words{"none", "cdt", "viscous", "epsd"};

}  // namespace mahlwerk::contact
