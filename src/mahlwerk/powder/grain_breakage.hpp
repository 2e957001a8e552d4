// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>

#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/powder/feed.hpp"
#include "mahlwerk/powder/sizes.hpp"
#include "mahlwerk/scene/grain_breakage.hpp"

namespace mahlwerk::powder {

/// Grains that an engine moves, and how they break.
struct BedBreakage {
  std::int32_t kind = 0;         ///< ball set of the grains
  double grain_size = 0;         ///< [m] > 0 diameter of the spheres at the start
  Feed feed;                     ///< sizes of the particles, where spheres represent several
  bool coarse = false;           ///< spheres represent many particles and keep their diameter
  double smallest_fragment = 0;  ///< [m] > 0 of the spheres, unless `coarse`
  double finest = 0;             ///< [m] > 0 smallest size that is resolved
  int per_octave = 3;            ///< size classes for a factor of two
  Indirect<AnyBreakage> breakage;
  Indirect<AnyFragments> fragments;
  std::uint64_t seed = 1;

  /// Size classes from the grains down to `finest`.
  SizeGrid grid() const;
  /// [m] Diameters of the spheres (scene::GrainBreakage::diameters).
  std::vector<double> diameters() const;
};

/// For the engine that moves the grains. Each grain has a strength if the breakage model tracks it
/// (brk.5); otherwise a uniform number, drawn for each stressing, decides by the probability.
std::shared_ptr<const scene::GrainBreakage> grain_breakage(const BedBreakage& bed);

}  // namespace mahlwerk::powder
