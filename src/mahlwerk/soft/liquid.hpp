// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "mahlwerk/contact/lubrication.hpp"
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

/// The liquid in a jar, for one run.
class LiquidForces {
 public:
  LiquidForces(const contact::Liquid& liquid, double time_step) : liquid_(liquid), dt_(time_step) {}

  bool acts_on_balls() const { return liquid_.flooded && liquid_.drag; }
  /// Largest gap [m] at which a pair feels the liquid.
  double gap_reach(std::span<const SpeciesPair> pairs) const;

  LiquidMotion motion(const MovingWall& jar, const DriveSample& drive, double t) const;
  /// Drag, torque and pressure on a ball (liq.5 to liq.8).
  LiquidLoad on_ball(const LiquidMotion& liquid, const Species& ball, const Vec3& position,
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
  contact::Liquid liquid_;
  double dt_;
};

}  // namespace mahlwerk::soft
