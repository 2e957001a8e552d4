// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "mahlwerk/results/outcome.hpp"

// Pictures of balls one by one, from the film of a result's first replicate.
namespace mahlwerk::report {

/// What the balls are seen from: riding with the jar's centre, and turning with what carries the
/// jar (the disc; of other mills nothing turns) or with the jar itself.
enum class View { carrier, jar };

/// One result among several that are drawn side by side.
struct Panel {
  std::string title;
  const results::Outcome* outcome = nullptr;
};

/// The ways of the balls (not of grains) in the plane of motion over the film, a colour for each
/// ball. Empty if no panel has a film.
std::string trajectories_picture(const std::vector<Panel>& panels, View view);

/// Balls and grains at the film's last time, seen along the normal of the plane of motion: balls
/// red; grains green, those faster than their root mean square, riding with the jar's centre,
/// yellow. Empty if no panel has a film.
std::string snapshot_picture(const std::vector<Panel>& panels, View view);

}  // namespace mahlwerk::report
