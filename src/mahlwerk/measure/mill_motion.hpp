// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "mahlwerk/measure/finding.hpp"

// The motion of a mill from marks in a film.
namespace mahlwerk::measure {

/// Positions of marks in the frames of a film, all in the same unit: pixels or m.
struct MarkTracks {
  struct Mark {
    std::vector<double> x, y;
  };
  std::vector<double> time;  ///< [s]
  std::vector<Mark> marks;   ///< as many positions as times
};

/// What is known besides the film; half-widths are 95 %.
struct FilmSetup {
  std::optional<observe::Estimate> scale;     ///< [m] length of a unit of the tracks
  std::optional<observe::Estimate> distance;  ///< [m] between the first two marks
  std::optional<observe::Estimate> arm;       ///< [m] of an arc shaker, for a single mark
};

/// Kinds of mills whose motion a film can give.
constexpr std::array<std::string_view, 5> filmed_kinds{"arc-shaker", "vibration", "planetary",
                                                       "circular", "tumbling"};

/// The numbers of a mill's kind, of `filmed_kinds`:
/// - arc-shaker: frequency; with two marks on arm or jar, the first at the middle of the jar, swing
///   and arm (mea.6, mea.7); with one mark half the stroke, and swing if the arm is known;
/// - vibration: frequency and amplitude; circular: speed and radius; tumbling: speed;
/// - planetary: from a mark near the rim of the jar speed, orbit radius and ratio (mea.8); a second
///   mark on the disc tells which rotation is that of the disc.
/// Lengths need `scale` or `distance`. Throws InputError if the tracks do not suffice.
Findings mill_motion(std::string_view kind, const MarkTracks& tracks, const FilmSetup& setup);

}  // namespace mahlwerk::measure
