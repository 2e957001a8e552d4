// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/grain_breakage.hpp"
#include "mahlwerk/scene/balls.hpp"

namespace mahlwerk::cases {

/// Breakage of grains while they move; absent from a case without [bed_breakage]. The models are
/// those of [breakage] and [fragments].
struct BedBreakage {
  Indirect<powder::AnyBreakage> breakage;
  Indirect<powder::AnyFragments> fragments;
  /// [m] of the spheres that fragments become; none: a quarter of the grains
  std::optional<double> smallest = std::nullopt;
  std::optional<double> finest =
      std::nullopt;  ///< [m] that is resolved; none: a 16th of `smallest`
  std::int64_t classes_per_octave = 3;
  /// of grains at a time; none: four times those at the start
  std::optional<std::int64_t> largest_number = std::nullopt;
  std::optional<double> interval = std::nullopt;  ///< [s] between samples; none: a hundredth
  bool operator==(const BedBreakage&) const = default;
};

struct Case;
/// Whether the grains of a case stand for many particles each, and keep their size.
bool coarse_grains(const Case& c);
/// The grains of a case with [bed_breakage], in one replicate.
powder::BedBreakage bed_breakage(const Case& c, int replicate = 0);
/// Balls outside the jar that become fragments: at least one of each size.
std::vector<scene::Ball> spare_grains(const Case& c);
/// The largest number of grains at a time.
std::int64_t largest_grain_number(const Case& c);

}  // namespace mahlwerk::cases
