// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/grain_breakage.hpp"

namespace mahlwerk::soft {

// Stream of random numbers, apart from other draws of the seed.
constexpr std::uint64_t fragment_stream = 0x667261676d656e74;
constexpr std::int64_t stressing_interval = 4;     // steps between two looks at the grains
constexpr std::int64_t longest_breakage = 256;     // steps in which a broken grain's load may rise
constexpr std::int64_t replacement_interval = 64;  // fewest steps between two exchanges of grains

/// State of a powder whose grains break (docs/theory/bed-breakage.md).
struct BreakageState {
  std::vector<scene::GrainState> grains;  ///< of each ball
  std::vector<double> fines;              ///< [kg] not simulated, by size class
  std::vector<double> due;                ///< [kg] of fragments of each class of spheres (bed.5)
  std::vector<double> stressed;           ///< [kg] fines that were stressed, by energy
  std::vector<std::int32_t> new_balls;    ///< fragments that were put in after the last step
  std::int64_t replaced = 0;              ///< grains so far
  std::int64_t replaced_at = -replacement_interval;  ///< step of the last exchange
  std::int64_t active = 1;                           ///< 0: until counting begins
  // Constants of a run.
  double powder = 0;                  ///< [kg]
  std::vector<std::int32_t> species;  ///< of each class of spheres; none if spheres stay
  std::vector<double> energy_share;   ///< [1] of the first body of each species pair (bed.2)
  std::vector<std::uint8_t> is_new;   ///< of each ball: it is one of new_balls

  void serialize(Archive& archive) {
    const auto sizes = [&] {
      return std::array{grains.size(), fines.size(), due.size(), stressed.size()};
    };
    const auto before = sizes();
    archive(grains)(fines)(due)(stressed)(new_balls)(replaced)(replaced_at)(active);
    if (sizes() != before) throw Archive::broken();
    if (!archive.reading()) return;
    for (const std::int32_t ball : new_balls) {
      if (ball < 0 || static_cast<std::size_t>(ball) >= is_new.size()) throw Archive::broken();
      is_new[static_cast<std::size_t>(ball)] = 1;
    }
  }
};

/// [m] The part of an overlap that presses: what exceeds `rest` [m], at which the contact is
/// without force (bed.6).
inline double pressed_overlap(double overlap, double rest) {
  return rest > 0 ? (overlap > rest ? overlap - rest : 0) : overlap;
}

}  // namespace mahlwerk::soft
