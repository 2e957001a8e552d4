// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/observe/wall_map.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::observe {

/// Impact angle [rad] of `approach` u_n > 0 and `slip` |u_t|: 0 head-on, pi/2 grazing; within 2e-8
/// rad.
double impact_angle(double approach, double slip);

/// The cell of WallGrid that a place on the wall belongs to: `where` in the jar's own axes, `axial`
/// the component of the normal along its axis.
int cell_of(const WallGrid& grid, const Vec3& where, double axial);

/// One number of some records, side by side.
template <class T>
struct alignas(64) Column {
  static constexpr std::size_t most = 64;
  T values[most];
  T operator[](std::size_t i) const { return values[i]; }
};

/// Some records side by side, and what follows from each, eight at a time: this is most of the work
/// of counting.
struct CollisionBatch {
  static constexpr std::size_t most = Column<double>::most;

  std::size_t count = 0;
  Column<double> mass, approach, slip, glide, lost_normal, lost_tangential, duration;
  Column<double> x, y, z, axial;  // [m] where; component of the normal along the jar's axis
  // What follows.
  Column<double> energy_normal, energy_tangential;           // [J] m u_n^2/2, m u_t^2/2
  Column<double> energy_contact_point, energy_centre, lost;  // [J]
  Column<double> angle;                                      // [rad]
  Column<double> erosion;                                    // [J] m u^2 f(alpha) (wea.4)
  // Bins of LogHistogram.
  Column<std::int64_t> bin_normal, bin_tangential, bin_contact_point, bin_centre, bin_lost,
      bin_lost_normal, bin_lost_tangential, bin_approach;
  Column<std::int64_t> cell;  // of WallGrid

  /// `records`: at most `most`; none of them counts for what the columns held before.
  void load(std::span<const scene::Collision> records, const WallGrid& wall);

 private:
  void compute_derived(const WallGrid& wall);
};

}  // namespace mahlwerk::observe
