// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <string>

#include "mahlwerk/results/outcome.hpp"

// Pictures of single balls, from the replay frames of one replicate.
namespace mahlwerk::report {

/// Reference frame of a picture: its origin is the jar's centre; it rotates with the carrier of the
/// jar (the disc; in other mills it does not rotate) or with the jar.
enum class View { carrier, jar };

/// [px] Height of the scale bar below the square of a picture.
constexpr double scale_bar_height = 18;

/// Whether the replicate has frames.
bool has_frames(const results::Outcome& outcome, std::size_t replicate);

/// Trajectories of the balls (not of grains) in the plane of motion over all frames, a colour for
/// each ball, and the balls as discs where they end, in a square of `size` [px] above a scale bar.
/// Empty without frames.
std::string trajectories_picture(const results::Outcome& outcome, std::size_t replicate, View view,
                                 double size);

/// Balls and grains in the last frame, seen along the normal of the plane of motion: balls red;
/// grains green, or yellow if faster than their root mean square speed relative to the jar's
/// centre. Empty without frames.
std::string snapshot_picture(const results::Outcome& outcome, std::size_t replicate, View view,
                             double size);

/// The numbers of these pictures as CSV: positions in the plane of motion, in the reference frame.
std::string trajectories_csv(const results::Outcome& outcome, std::size_t replicate, View view);
std::string snapshot_csv(const results::Outcome& outcome, std::size_t replicate, View view);

}  // namespace mahlwerk::report
