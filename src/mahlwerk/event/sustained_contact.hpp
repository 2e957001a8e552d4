// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/contact/bounce.hpp"

namespace mahlwerk::event {

/// The collision rule of the TC model with a limit on the speed (man.4). Hard spheres in sustained
/// contact make small bounces instead, which must not die out: they would become countless.
/// No collision gains energy: losses along the normal and the surface together are never negative.
struct SustainedContact {
  double contact_time = 0;  ///< [s] t_c
  double friction = 0;      ///< Coulomb's mu where the pair's rule has no limit

  /// Two bodies that collide.
  struct Approach {
    double mass, normal, slip;  ///< [kg] effective, [m/s] u_n > 0 and |u_t|
    double since;               ///< [s] since the last collision of either body
    double field;               ///< [m/s2] a, the strongest that presses the two together
  };
  struct Result {
    contact::Impulse impulse;
    contact::Loss loss;
    double withheld = 0;  ///< [J] that the pair's restitution would have dissipated besides
    bool raised = false;  ///< made more elastic than the pair's restitution says
  };

  /// Slowest rebound as far as the energy of the collision allows it [m/s] (man.4).
  double slowest_rebound(double since, double field) const {
    constexpr double alone = 0.5, crowded = 10;
    const double crowding = std::max(0.0, 1 - since / contact_time);
    return (alone + (crowded - alone) * crowding) * field * contact_time;
  }

  Result collide(const contact::BounceRule& rule, const Approach& in) const {
    const double slowest = slowest_rebound(in.since, in.field), u = in.normal;
    const double e = rule.restitution.at(u);
    const double withheld = 0.5 * in.mass * u * u * (1 - e * e);
    if (u >= slowest) {
      const double raised = std::max(e, slowest / u);
      Result result = bounce(rule, in, raised);
      result.withheld = withheld - result.loss.normal;
      result.raised = raised > e;
      return result;
    }
    const double mu = rule.tangential_restitution == 1 ? 0  // smooth (evt.15)
                      : std::isfinite(rule.friction)   ? rule.friction
                                                       : friction;
    const double raised = std::min(slowest / u, affordable(mu, u, in.slip));
    Result result = bounce({1, -1, mu}, in, std::max(1.0, raised));
    result.withheld = withheld;
    result.raised = true;
    return result;
  }

 private:
  /// The restitution with which sliding at the Coulomb limit dissipates just what the rebound gains
  /// (man.5); below 1 where the contact sticks.
  static double affordable(double mu, double u, double slip) {
    const double inertia = 1.75 * mu * mu * u;
    return (0.5 * u + mu * slip - inertia) / (0.5 * u + inertia);
  }

  static Result bounce(const contact::BounceRule& rule, const Approach& in, double restitution) {
    const contact::Impulse j = contact::bounce(rule, in.mass, in.normal, in.slip, restitution);
    return {j, contact::loss(j, in.mass, in.normal, in.slip)};
  }
};

}  // namespace mahlwerk::event
