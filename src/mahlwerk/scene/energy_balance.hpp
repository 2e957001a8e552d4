// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace mahlwerk::scene {

/// Energy balance of a run since its start, in laboratory axes. All in J unless said otherwise.
struct EnergyBalance {
  double time = 0;             ///< [s] simulated
  double kinetic = 0;          ///< now, translation and rotation
  double potential = 0;        ///< now, in gravity
  double initial_energy = 0;   ///< kinetic + potential at the start
  double wall_work = 0;        ///< done by the jar on the balls, also through a liquid
  double lost_normal = 0;      ///< dissipated in collisions, along the normal
  double lost_tangential = 0;  ///< dissipated in collisions, along the wall
  double lost_lasting = 0;     ///< in sustained contacts: sliding, rolling, and on entering one
  double lost_rolling = 0;     ///< dissipated by rolling resistance of touching bodies
  double lost_liquid = 0;      ///< dissipated by the flow of a liquid between and around balls
  double lost_breakage = 0;    ///< of grains that broke, less those of their fragments (bed.9)
  double elastic = 0;          ///< stored in contacts now
  double flow = 0;             ///< of balls that have entered the jar, less those that left (flo.3)
  double lost_open = 0;        ///< part of the losses: by open contacts, not in any record yet
  double slid = 0;             ///< part of lost_tangential: by slip at the Coulomb limit
  double worst_collision = 0;  ///< [1] largest relative residual of one collision's balance
  double deepest_overlap = 0;  ///< [1] largest overlap at a collision, over the ball's radius
  double contact_time = 0;     ///< [s] ball time in sustained contact
  std::int64_t collisions = 0;
  std::int64_t broken_grains = 0;
  std::int64_t lasting_contacts = 0;  ///< number of sustained contacts begun
  std::int64_t tc_collisions = 0;     ///< made more elastic by the TC rule
  double lost_within = 0;  ///< part of the losses: in collisions within t_c of another of a body
  double withheld = 0;     ///< restitution would have dissipated it; the TC rule kept it
  std::int64_t hits_within = 0;  ///< collisions within t_c, above the threshold
  // Of a mill that a motor turns (kin.26).
  double motor_work = 0;          ///< of the motor on the mill
  double drive_kinetic = 0;       ///< now, of jar and drive without balls
  double mill_speed = 0;          ///< [rad/s] now
  double mill_angle = 0;          ///< [rad] turned since the start
  std::int64_t search_steps = 0;  ///< steps of the touch search
  std::int64_t time_steps = 0;    ///< time steps of the soft engine

  double lost() const {
    return lost_normal + lost_tangential + lost_lasting + lost_rolling + lost_liquid +
           lost_breakage;
  }
  /// Residual of the balance, > 0 if energy appeared (dem.32).
  double residual() const {
    return kinetic + potential + elastic - initial_energy - flow - wall_work + lost();
  }
};

}  // namespace mahlwerk::scene
