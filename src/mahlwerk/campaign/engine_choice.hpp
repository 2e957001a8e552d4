// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {

/// Above this share of the balls' time in contact the event engine's answer is a gas of tiny
/// bounces, and the soft engine is advised (docs/theory/many-balls.md).
constexpr double most_contact = 0.25;

/// What the share of time in contact of a short pilot run says; the same on any machine.
struct Pilot {
  double time = 0;   ///< [s] simulated
  double share = 0;  ///< of the balls' time in contact, in the second half
};
Pilot pilot(const cases::Case& what);

/// Which engine ran, why, and whether another is advised.
std::vector<std::string> notes_on(const results::Outcome& outcome);

}  // namespace mahlwerk::campaign
