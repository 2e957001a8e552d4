// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>

#include "mahlwerk/base/lanes.hpp"
#include "mahlwerk/observe/wall_map.hpp"
#include "mahlwerk/scene/collision.hpp"

namespace mahlwerk::observe {

/// Impact angle [rad] for `approach` u_n > 0 and `slip` |u_t|: 0 head-on, pi/2 grazing (obs.1).
/// Accurate within 2e-8 rad.
double impact_angle(double approach, double slip);

/// The cell of WallGrid of a point on the wall. `where` [m]: the point in the jar's own axes.
/// `axial`: component of the normal along the jar's axis.
int cell_of(const WallGrid& grid, const Vec3& where, double axial);

/// One number of several records in contiguous memory (structure of arrays).
template <class T>
struct alignas(64) Column {
  static constexpr std::size_t most = 64;
  T values[most];
  T operator[](std::size_t i) const { return values[i]; }
};

/// Collision records as a structure of arrays, and numbers derived from them by SIMD. This is most
/// of the work of collision statistics.
struct CollisionBatch {
  static constexpr std::size_t most = Column<double>::most;

  CollisionBatch();

  std::size_t count = 0;
  Column<double> mass, approach, slip, glide, lost_normal, lost_tangential, duration;
  Column<double> x, y, z, axial;  // [m] contact point; axial component of the normal
  // Derived numbers:
  Column<double> energy_normal, energy_tangential;           // [J] m u_n^2/2, m u_t^2/2
  Column<double> energy_contact_point, energy_centre, lost;  // [J]
  Column<double> angle;                                      // [rad]
  Column<double> erosion;                                    // [J] m u^2 f(alpha) (wea.4)
  // Bins of LogHistogram.
  Column<std::int64_t> bin_normal, bin_tangential, bin_contact_point, bin_centre, bin_lost,
      bin_lost_normal, bin_lost_tangential, bin_approach;
  Column<std::int64_t> cell;  // of WallGrid

  /// Replaces the content by `records`, at most `most`.
  void load(std::span<const scene::Collision> records, const WallGrid& wall);

 private:
  struct Derive;
  template <class V>
  void derive(const WallGrid& wall);

  void (*derive_)(CollisionBatch&, const WallGrid&);  // compiled for the instruction set
};

}  // namespace mahlwerk::observe
