// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/contact/bounce.hpp"

namespace mahlwerk::event {

/// What to do when bounces become countless and ever smaller (docs/theory/event.md, "Collapse").
enum class SustainedContactMode { roll, tc, none };

/// How one ball and its jar meet, and how the engine treats collapse.
struct Rules {
  contact::BounceRule bounce;
  std::vector<contact::BounceRule> faces;  ///< by face of the jar, where they are not all alike
  double lasting_friction = 0.3;           ///< mu of lasting contacts; they need a limit (evt.15)
  double rolling_friction = 0;             ///< mu_r of lasting contacts
  SustainedContactMode lasting = SustainedContactMode::roll;
  double lasting_speed = 1e-4;  ///< [m/s] a slower rebound, pressed to the wall, has come to stay
  double contact_time = 1e-4;   ///< [s] t_c of the TC rule
  double threshold = 0;         ///< [m/s] hits slower than this are not counted in hits_within

  const contact::BounceRule& wall(int face) const {
    return faces.empty() ? bounce : faces[static_cast<std::size_t>(face)];
  }
};

}  // namespace mahlwerk::event
