// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/geometry/prism.hpp"
#include "mahlwerk/geometry/surface.hpp"
#include "mahlwerk/powder/ball_charge.hpp"

namespace mahlwerk::campaign {

/// Volumes that bodies have lost since the start [m3].
struct LostVolumes {
  double jar = 0, parts = 0, balls = 0;
  double scrapped = 0, added = 0;  ///< balls that were too small, and fresh ones
};

/// Shapes and sizes after some time of operation. Which bodies they belong to is in WornCase.
struct WornState {
  double time = 0;                          ///< [s] of operation
  double diameter = 0, height = 0;          ///< [m] of a round jar; 0: its shape stays
  std::vector<geometry::Section> sections;  ///< of bars and lifters
  std::vector<geometry::Surface> surfaces;  ///< of meshes
  std::vector<powder::BallCharge> charges;  ///< of each ball set without grains
  LostVolumes lost;

  void serialize(Archive& archive) {
    archive(time)(diameter)(height)(lost);
    sizes(archive, sections);
    for (geometry::Section& one : sections) archive(one);
    sizes(archive, surfaces);
    for (geometry::Surface& one : surfaces) archive(one.points)(one.triangles);
    sizes(archive, charges);
    for (powder::BallCharge& one : charges) archive(one);
  }

 private:
  template <class List>
  static void sizes(Archive& archive, List& list) {
    auto count = static_cast<std::uint64_t>(list.size());
    archive(count);
    constexpr std::uint64_t most = 1000;  // bodies of a case
    if (count > most) throw Archive::broken();
    if (archive.reading()) list.resize(count);
  }
};

}  // namespace mahlwerk::campaign
