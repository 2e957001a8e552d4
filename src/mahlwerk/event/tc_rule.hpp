// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>

#include "mahlwerk/contact/bounce.hpp"

namespace mahlwerk::event {

/// TC model, modified: instead of restitution 1 within t_c, the rebound speed has a lower limit
/// (man.4). A sustained contact is a train of small bounces, which this limit keeps from collapsing
/// (inelastic collapse). A rebound faster than the approach is paid for by sliding loss or by
/// energy stored from earlier losses of the two bodies (man.6).
struct TcRule {
  double contact_time = 0;  ///< [s] t_c
  double friction = 0;      ///< Coulomb's mu where the pair's rule has no limit

  /// Two bodies that collide.
  struct CollisionInput {
    double mass, approach, slip;   ///< [kg] effective, [m/s] u_n > 0 and |u_t|
    double since;                  ///< [s] since the last collision of either body
    double pressing_acceleration;  ///< [m/s2] a, largest acceleration that presses the two together
    double stored = 0;             ///< [J] by both bodies together
    double slip_factor = contact::solid_slip_factor;  ///< [1] of the two bodies (hol.4)
  };
  struct Result {
    contact::Impulse impulse;
    contact::Loss loss;
    double drawn = 0;           ///< [J] taken from the store; the loss is less by it
    double stored_change = 0;   ///< [J] change of the stored energy (StoredEnergy::update)
    double withheld = 0;        ///< [J] that the pair's restitution would have dissipated, too
    bool raised = false;        ///< more elastic than the pair's restitution
    double liquid_impulse = 0;  ///< [N s] normal, of a liquid before the bodies touch
    double liquid_loss = 0;     ///< [J] dissipated by it
    double twisting_loss = 0;   ///< [J] dissipated by twisting friction (evt.26)

    /// A liquid slows bodies of effective mass `mass` [kg] down from `approach` to `touch` [m/s].
    void slow_down(double mass, double approach, double touch) {
      liquid_impulse = mass * (approach - touch);
      liquid_loss = 0.5 * liquid_impulse * (approach + touch);
    }
    /// Speed at which they touch [m/s].
    double touch_speed(double mass, double approach) const {
      return approach - liquid_impulse / mass;
    }
    contact::Impulse total_impulse() const {
      return {impulse.normal + liquid_impulse, impulse.tangential};
    }
  };

  /// Lower limit of the rebound speed [m/s], not reached if energy is lacking (man.4). It falls
  /// linearly from 10 a t_c right after a collision to 0.5 a t_c after t_c. `since` [s] is the time
  /// since the last collision of either body, `pressing_acceleration` [m/s2] is a, as in
  /// CollisionInput.
  double min_rebound_speed(double since, double pressing_acceleration) const {
    constexpr double alone = 0.5, crowded = 10;
    const double crowding = std::max(0.0, 1 - since / contact_time);
    return (alone + (crowded - alone) * crowding) * pressing_acceleration * contact_time;
  }
  /// Speed [m/s] at which bodies touch in a film that slows them down from `approach` to `touch`.
  /// Slower bounces than the lower limit stand for a sustained contact, which no film interrupts.
  double wet_approach(double approach, double touch, double since,
                      double pressing_acceleration) const {
    const double limit = std::min(approach, min_rebound_speed(since, pressing_acceleration));
    return std::max({touch, limit, 1e-200});
  }
  /// Energy that a body of `mass` [kg] stores at most [J].
  double storage_capacity(double mass, double pressing_acceleration) const {
    const double speed = min_rebound_speed(0, pressing_acceleration);
    return 0.5 * mass * speed * speed;
  }

  Result collide(const contact::BounceRule& rule, const CollisionInput& in) const {
    const double min_rebound = min_rebound_speed(in.since, in.pressing_acceleration),
                 u = in.approach;
    const double e = rule.restitution.at(u);
    const double withheld = 0.5 * in.mass * u * u * (1 - e * e);
    if (u >= min_rebound) {
      const double restitution = std::max(e, min_rebound / u);
      Result result = bounce(rule, in, restitution);
      result.withheld = withheld - result.loss.normal;
      result.raised = restitution > e;
      return result;
    }
    const double mu = rule.tangential_restitution == 1 ? 0  // smooth (evt.15)
                      : std::isfinite(rule.friction)   ? rule.friction
                                                       : friction;
    const double wanted_restitution = min_rebound / u;
    const double affordable_restitution = std::max(
        1.0, std::min(wanted_restitution, neutral_restitution(mu, u, in.slip, in.slip_factor)));
    Result result = bounce({1, -1, mu}, in, affordable_restitution);
    const double enough = 0.5 * min_rebound;  // `min_rebound` itself would agitate beds too much
    if (affordable_restitution * u < enough && in.stored > 0)
      draw(result, in, affordable_restitution * u, enough);
    result.withheld = withheld;
    result.raised = true;
    return result;
  }

 private:
  /// Restitution at which the loss by sliding at the Coulomb limit equals the energy gain of the
  /// rebound (man.5). Below 1 where the Coulomb limit is not reached: then nothing pays for a gain.
  static double neutral_restitution(double mu, double u, double slip, double factor) {
    const double inertia = 0.5 * factor * mu * mu * u;
    return (0.5 * u + mu * slip - inertia) / (0.5 * u + inertia);
  }

  /// Raises the rebound from `speed` towards `enough` [m/s] with stored energy. The tangential
  /// impulse is unchanged.
  static void draw(Result& result, const CollisionInput& in, double speed, double enough) {
    const double half = 0.5 * in.mass;
    const double drawn = std::min(in.stored, half * (enough * enough - speed * speed));
    const double rebound = std::sqrt(speed * speed + drawn / half);
    result.impulse.normal = in.mass * (in.approach + rebound);
    result.loss.normal -= drawn;
    result.drawn = drawn;
  }

  static Result bounce(const contact::BounceRule& rule, const CollisionInput& in,
                       double restitution) {
    const contact::Impulse j =
        contact::bounce(rule, in.mass, in.approach, in.slip, restitution, in.slip_factor);
    return {j, contact::loss(j, in.mass, in.approach, in.slip, in.slip_factor)};
  }
};

/// Energy [J] that two bodies have stored from earlier losses, each up to its capacity. One of the
/// bodies may be the wall, which stores nothing. Sustained contacts draw on this energy (man.6).
class StoredEnergy {
 public:
  StoredEnergy(double& one, double capacity) : one_(&one), one_capacity_(capacity) {}
  StoredEnergy(double& one, double capacity, double& other, double other_capacity)
      : one_(&one), other_(&other), one_capacity_(capacity), other_capacity_(other_capacity) {}

  double sum() const { return *one_ + (other_ != nullptr ? *other_ : 0.0); }
  /// Withdraws the drawn energy, or stores the loss as far as the capacity allows. Afterwards the
  /// collision's loss is the energy that is really dissipated.
  void update(TcRule::Result& collision) {
    const double before = sum();
    contact::Loss& loss = collision.loss;
    const double lost = loss.normal + loss.tangential;
    if (collision.drawn > 0) {
      take(collision.drawn);
      loss.normal += collision.drawn;
    } else if (lost > 0) {
      put(lost);
      const double left = std::max(0.0, 1 - (sum() - before) / lost);
      loss.normal *= left;
      loss.tangential *= left;
    }
    collision.stored_change = sum() - before;
  }

 private:
  void take(double energy) {
    const double of_one = std::min(*one_, energy);
    *one_ -= of_one;
    if (other_ != nullptr) *other_ = std::max(0.0, *other_ - (energy - of_one));
  }
  void put(double energy) {
    if (other_ == nullptr) {
      *one_ = std::min(one_capacity_, *one_ + energy);
      return;
    }
    *one_ = std::min(one_capacity_, *one_ + 0.5 * energy);
    *other_ = std::min(other_capacity_, *other_ + 0.5 * energy);
  }

  double *one_, *other_ = nullptr;
  double one_capacity_, other_capacity_ = 0;
};

}  // namespace mahlwerk::event
