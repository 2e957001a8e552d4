// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

// Pictures of single balls, from the replay frames of the first replicate.
namespace mahlwerk::report {

/// Reference frame of a picture: its origin is the jar's centre; it rotates with the carrier of the
/// jar (the disc; in other mills it does not rotate) or with the jar.
enum class View { carrier, jar };

/// One of several outcomes that are drawn side by side.
struct Panel {
  std::string title;
  const results::Outcome* outcome = nullptr;
};

/// Trajectories of the balls (not of grains) in the plane of motion over all frames, a colour for
/// each ball. Empty if no panel has frames.
std::string trajectories_picture(const std::vector<Panel>& panels, View view);

/// Balls and grains in the last frame, seen along the normal of the plane of motion: balls red;
/// grains green, or yellow if faster than their root mean square speed relative to the jar's
/// centre. Empty if no panel has frames.
std::string snapshot_picture(const std::vector<Panel>& panels, View view);

}  // namespace mahlwerk::report
