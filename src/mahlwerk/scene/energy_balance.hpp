// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace mahlwerk::scene {

/// Where a run's energy went since its start, in laboratory axes. All in J unless said otherwise.
struct EnergyBalance {
  double time = 0;             ///< [s] simulated
  double kinetic = 0;          ///< now, translation and rotation
  double potential = 0;        ///< now, in gravity
  double initial_energy = 0;   ///< kinetic + potential at the start
  double wall_work = 0;        ///< done by the jar on the balls
  double lost_normal = 0;      ///< dissipated in collisions, along the normal
  double lost_tangential = 0;  ///< dissipated in collisions, along the wall
  double lost_lasting =
      0;  ///< dissipated in lasting contacts: sliding, rolling, and on entering one
  double lost_rolling = 0;  ///< dissipated by rolling resistance of touching bodies
  double elastic = 0;       ///< stored in contacts now
  double lost_open = 0;     ///< of the losses, by contacts that go on: no record tells of them yet
  double slid = 0;          ///< of lost_tangential, by slip at the Coulomb limit
  double worst_collision = 0;  ///< [1] largest relative residual of one collision's balance
  double deepest_overlap = 0;  ///< [1] of two bodies as they collided, over the ball's radius
  double contact_time = 0;     ///< [s] ball time in lasting contact
  std::int64_t collisions = 0;
  std::int64_t lasting_contacts = 0;  ///< how many began
  std::int64_t tc_collisions = 0;     ///< made elastic by the TC rule
  double lost_within = 0;  ///< of the losses, in collisions within t_c of another of the same body
  double withheld = 0;     ///< that restitution would have dissipated, kept by the TC rule
  std::int64_t hits_within = 0;   ///< collisions within t_c, above the threshold
  std::int64_t search_steps = 0;  ///< of the search of touches
  std::int64_t time_steps = 0;    ///< computed by the soft engine

  double lost() const { return lost_normal + lost_tangential + lost_lasting + lost_rolling; }
  /// Energy that appeared from nowhere (dem.32).
  double residual() const {
    return kinetic + potential + elastic - initial_energy - wall_work + lost();
  }
};

}  // namespace mahlwerk::scene
