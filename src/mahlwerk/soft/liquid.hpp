// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <numbers>

#include "mahlwerk/contact/lubrication.hpp"
#include "mahlwerk/soft/kernel/step_data.hpp"
#include "mahlwerk/soft/species_pairs.hpp"
#include "mahlwerk/soft/walls/moving_wall.hpp"

// Forces of a liquid on balls that do not touch (docs/theory/liquid.md). They are computed ball by
// ball and pair by pair, apart from the packets of contacts.
namespace mahlwerk::soft {

/// Energy of the liquid's forces since the last time it was added to a balance [J].
struct LiquidWork {
  double lost = 0;  ///< dissipated in the liquid
  double wall = 0;  ///< done by the jar on the balls, through the liquid
};

/// Motion of the liquid in a step: it turns with the jar like a rigid body (liq.5).
struct LiquidMotion {
  Vec3 jar_velocity;          ///< [m/s] of the jar's centre
  Vec3 body_acceleration;     ///< [m/s2] gravity minus the acceleration of the jar's centre
  Vec3 spin;                  ///< [rad/s]
  Vec3 angular_acceleration;  ///< [rad/s2]
};

struct LiquidLoad {
  Vec3 force, torque;  ///< [N], [N m]
};
/// The same of a register of balls, or of one (V a double), and the work of the step.
template <class V>
struct LiquidLoads {
  Vec<V> force, torque;
  V lost, wall;  ///< [J] as in LiquidWork
};

/// The liquid in a jar, for one run.
class LiquidForces {
 public:
  LiquidForces(const contact::Liquid& liquid, double time_step) : liquid_(liquid), dt_(time_step) {}

  const contact::Liquid& liquid() const { return liquid_; }
  double time_step() const { return dt_; }
  bool acts_on_balls() const { return liquid_.flooded && liquid_.drag; }
  /// Mass [kg] of the liquid that a ball displaces.
  double displaced_mass(const Species& ball) const {
    return ball.mass / ball.density * liquid_.density;
  }
  /// Largest gap [m] at which a pair feels the liquid.
  double gap_reach(std::span<const SpeciesPair> pairs) const;

  LiquidMotion motion(const MovingWall& jar, const DriveSample& drive, double t) const;
  /// Drag, torque and pressure on balls (liq.5 to liq.8).
  template <class V>
  [[gnu::always_inline]] LiquidLoads<V> on_balls(const LiquidMotion& motion, const V& radius,
                                                 const V& displaced, const Vec<V>& position,
                                                 const Vec<V>& velocity, const Vec<V>& spin) const;
  LiquidLoad on_ball(const LiquidMotion& motion, const Species& ball, const Vec3& position,
                     const Vec3& velocity, const Vec3& spin, LiquidWork& work) const;
  /// Force [N] on ball i of a pair that does not touch; the opposite force acts on ball j.
  /// `separation` [m] from i to j, `velocity` [m/s] of i relative to j. `weight`: share of the work
  /// that counts.
  Vec3 between_balls(const SpeciesPair& pair, double radii, const Vec3& separation,
                     const Vec3& velocity, double weight, LiquidWork& work) const;
  /// Force [N] on a ball near a face, which has the distance and inward normal `gap`. `drive`: the
  /// motion of the jar, `turning`: the spin of the face.
  Vec3 at_wall(const SpeciesPair& pair, double radius, const geometry::Gap& gap,
               const Vec3& position, const Vec3& velocity, const Vec3& turning,
               const Vec3& jar_velocity, LiquidWork& work) const;

 private:
  double force_of(const SpeciesPair& pair, double gap, double approach) const;  // [N]

  contact::Liquid liquid_;
  double dt_;
};

template <class V>
inline LiquidLoads<V> LiquidForces::on_balls(const LiquidMotion& motion, const V& radius,
                                             const V& displaced, const Vec<V>& position,
                                             const Vec<V>& velocity, const Vec<V>& spin) const {
  constexpr double pi = std::numbers::pi;
  const double eta = liquid_.viscosity;
  const Vec<V> turning = in_all_lanes<V>(motion.spin),
               jar_velocity = in_all_lanes<V>(motion.jar_velocity);
  const Vec<V> flow = cross(turning, position), slip = velocity - flow;
  const V reynolds = liquid_.density * sqrt(dot(slip, slip)) * 2.0 * radius / eta;
  const Vec<V> drag = -(6 * pi * eta * radius * contact::drag_correction(reynolds)) * slip;
  const Vec<V> acceleration =
      cross(in_all_lanes<V>(motion.angular_acceleration), position) + cross(turning, flow);
  const Vec<V> pressure = displaced * (acceleration - in_all_lanes<V>(motion.body_acceleration));
  const Vec<V> slip_spin = spin - turning;
  const Vec<V> torque = -(8 * pi * eta * radius * radius * radius) * slip_spin;
  return {drag + pressure, torque, -(dt_ * (dot(drag, slip) + dot(torque, slip_spin))),
          dt_ * (dot(drag, flow + jar_velocity) + dot(torque, turning) +
                 dot(pressure, velocity + jar_velocity))};
}

}  // namespace mahlwerk::soft
