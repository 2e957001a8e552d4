// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/contact/twisting_impulse.hpp"
#include "mahlwerk/event/collapse.hpp"
#include "mahlwerk/event/guard.hpp"
#include "mahlwerk/event/search.hpp"
#include "mahlwerk/event/sustained_contact_integrator.hpp"
#include "mahlwerk/event/tc_rule.hpp"
#include "mahlwerk/kinematics/strongest_field.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

/// The event engine for one ball: flight, touch, bounce, and sustained contact where bounces
/// collapse. In a periodic mill of static geometry the clock stays within one period, so accuracy
/// does not decrease with time.
template <class S, class M>
class OneBall final : public scene::Engine {
 public:
  OneBall(const TypedChamber<S, M>& jar, const scene::Ball& ball, const Rules& rules, double start)
      : jar_(jar),
        body_{ball.radius, ball.mass(), ball.inertia(), ball.inertia_ratio},
        rules_(rules),
        tolerance_(touch_tolerance(jar_, ball.radius)),
        integrator_(jar_, body_, rules, tolerance_),
        spin_(ball.spin),
        pressing_acceleration_(kinematics::strongest_field(
            jar_.gravity(), jar_.motion_bounds().acceleration, jar_.motion().period(),
            [&](double t) { return jar_.motion().frame_motion(t); })),
        start_(start) {
    const double period = jar_.static_geometry() ? jar_.motion().period() : kinematics::no_period;
    clock_range_ = period;
    clock_origin_ = std::isfinite(period) ? std::floor(start / period) * period : 0.0;
    now_.time = start - clock_origin_;
    now_.frame = jar_.motion().frame_motion(now_.time);
    start_flight({ball.position, ball.velocity});
    energy_balance_.kinetic = kinetic(flight_.velocity, spin_);
    energy_balance_.potential = potential(flight_.position);
    energy_balance_.initial_energy = energy_balance_.kinetic + energy_balance_.potential;
    finished_.reserve(max_records);
  }

  void advance(double time, scene::Observer& observer) override {
    const double until = time + start_;
    try {
      while (mill_time() < until) {
        if (stopped()) {
          reached_ = std::max(reached_, mill_time() - start_);
          return hand_over(observer);
        }
        if (in_contact_) {
          advance_contact();
          continue;
        }
        const Touch touch =
            next_touch(jar_, flight_, now_, until - clock_origin_, tolerance_);  // (evt.3)
        energy_balance_.search_steps += touch.steps;
        now_ = touch.when;
        in_contact_until_now_ = false;
        if (touch.face < 0) {
          if (!(now_.time < until - clock_origin_)) break;
          // For the Zeno guard, sixteen search steps count as an event.
          zeno_count_ += static_cast<int>(touch.steps / 16);
          check_zeno();
          continue;
        }
        collide(touch.face);  // (evt.6) to (evt.8)
        if (collapses(touch.face)) begin_contact(touch.face);
        check_zeno();
        wrap_clock();
        if (finished_.size() >= max_records) hand_over(observer);
      }
    } catch (...) {
      reached_ = mill_time() - start_;
      hand_over(observer);
      throw;
    }
    reached_ = time;
    hand_over(observer);
  }

  scene::EnergyBalance energy_balance() const override {
    scene::EnergyBalance a = energy_balance_;
    a.time = reached_;
    const kinematics::FrameMotion frame = jar_.motion().frame_motion(clock_reached());
    const ContactState now = state_at_time_reached();
    a.contact_time -= contact_ahead();
    a.wall_work += now.work;
    a.lost_lasting += now.lost;
    a.kinetic = kinetic(now.velocity + frame.velocity, now.spin);
    a.potential = potential(now.position + frame.centre);
    return a;
  }

  std::vector<scene::Ball> balls() const override {
    const ContactState now = state_at_time_reached();
    const double density = body_.mass / (4.0 / 3.0 * std::numbers::pi * math::pow(body_.radius, 3));
    return {{body_.radius, density, now.position, now.velocity, now.spin, 0, body_.inertia_ratio}};
  }

  void serialize(Archive& archive) override {
    archive(flight_)(spin_)(
        in_contact_)(in_contact_until_now_)(now_)(clock_origin_)(reached_)(stored_)(rebound_)(last_contact_time_);
    archive(zeno_count_)(zeno_since_)(energy_balance_);
    integrator_.serialize(archive);
  }

 private:
  static constexpr std::size_t max_records = 256;

  double kinetic(const Vec3& lab_velocity, const Vec3& spin) const {
    return 0.5 * body_.mass * squared(lab_velocity) + 0.5 * body_.inertia * squared(spin);
  }
  double potential(const Vec3& lab_position) const {
    return -body_.mass * dot(jar_.gravity(), lab_position);
  }

  /// The time reached on the engine's clock [s].
  double clock_reached() const { return reached_ + start_ - clock_origin_; }
  /// Time [s] by which the last step of a sustained contact passed the time reached. Its length is
  /// that of the step-size control whatever the time asked for, so that cuts change no bits.
  double contact_ahead() const {
    return in_contact_until_now_ ? std::max(now_.time - clock_reached(), 0.0) : 0.0;
  }
  /// The ball at the time reached, in the jar frame; in a sustained contact with the work and the
  /// loss that the energy balance lacks, < 0 if the last step passed that time.
  ContactState state_at_time_reached() const {
    if (in_contact_until_now_) return integrator_.state_before_end(contact_ahead());
    const double at = clock_reached();
    const BallState p = flight_.ball_state(at, jar_.gravity(), jar_.motion().frame_motion(at));
    return {p.position, p.velocity, spin_};
  }

  /// Starts a flight now with the state `p` in the jar frame.
  void start_flight(const BallState& p) {
    now_.ball = p;
    flight_ = {now_.time, p.position + now_.frame.centre, p.velocity + now_.frame.velocity};
  }

  /// Applies an impulse of the wall [N s] to the velocity in `p` and to the spin. Returns the work
  /// of the wall [J].
  double apply_impulse(const Vec3& impulse, const Wall& wall, BallState& p) {
    p.velocity += impulse / body_.mass;
    spin_ -= body_.radius / body_.inertia * cross(wall.inward, impulse);
    return dot(impulse, now_.frame.velocity + wall.velocity);
  }

  [[gnu::flatten]] void collide(int face) {
    const double m = body_.mass, r = body_.radius;
    const Wall wall = jar_.wall(face, now_.ball.position, now_.time, r);
    const Vec3 n = -wall.inward, relative_velocity = now_.ball.velocity - wall.velocity;
    const double approach = dot(relative_velocity, n);
    energy_balance_.deepest_overlap = std::max(energy_balance_.deepest_overlap, -wall.gap / r);
    const Vec3 tangential_velocity = relative_velocity - approach * n,
               slip_velocity = tangential_velocity + r * cross(spin_, n);
    const double slip = norm(slip_velocity);

    const double touch = touch_speed(wall, approach);
    const auto [j, loss, stored_change, raised] = bounce(face, wall, touch, slip);
    const double liquid_impulse = m * (approach - touch);
    const double liquid_loss = 0.5 * liquid_impulse * (approach + touch);
    reject_energy_gain(loss, m, approach, slip, mill_time() - start_);
    const Vec3 impulse =
        -(j.normal + liquid_impulse) * n - (slip > 0 ? j.tangential / slip : 0.0) * slip_velocity;

    BallState after = now_.ball;
    const double before = kinetic(after.velocity + now_.frame.velocity, spin_);
    double work = apply_impulse(impulse, wall, after), twisting_loss = 0;
    if (rules_.twisting && !raised) [[unlikely]]
      twisting_loss = twist(face, n, touch, j.normal, work);
    const double gained = kinetic(after.velocity + now_.frame.velocity, spin_) - before;
    check_balance(energy_balance_, gained, work,
                  loss.normal + loss.tangential + stored_change + liquid_loss + twisting_loss,
                  before);

    energy_balance_.wall_work += work;
    energy_balance_.lost_normal += loss.normal;
    energy_balance_.lost_tangential += loss.tangential;
    energy_balance_.lost_liquid += liquid_loss;
    energy_balance_.lost_rolling += twisting_loss;
    energy_balance_.elastic += stored_change;
    ++energy_balance_.collisions;
    record(face, wall, n, touch, slip, norm(tangential_velocity), j.normal,
           {loss.normal, loss.tangential + twisting_loss});
    rebound_ = j.normal / m - touch;
    last_contact_time_ = mill_time();
    start_flight(after);
  }

  /// Changes the spin about `n` by the twisting friction of a collision, and `work` [J] by that of
  /// the wall. Returns the loss [J]. Not inlined: few cases have it, and collide() is short.
  [[gnu::noinline]] double twist(int face, const Vec3& n, double approach, double normal,
                                 double& work) {
    const double jar_spin = dot(jar_.motion().spin(now_.time), n);
    const contact::Twist twist =
        contact::twist(body_.twisting_pair(rules_, face), rules_.wall(face), body_.inertia,
                       approach, normal, dot(spin_, n) - jar_spin);
    spin_ -= twist.impulse / body_.inertia * n;
    work -= twist.impulse * jar_spin;
    return twist.loss;
  }

  struct Bounce {
    contact::Impulse impulse;
    contact::Loss loss;
    double stored_change = 0;  ///< [J] change of the stored energy (man.6)
    bool raised = false;       ///< more elastic than the wall's rule, by the TC rule (man.4)
  };
  /// Largest acceleration that presses the ball to the wall [m/s2].
  double pressing_acceleration(const Wall& wall) const {
    return pressing_acceleration_ + squared(tangential_part(now_.ball.velocity, wall.inward)) *
                                        std::max(wall.curvature, 0.0);
  }
  /// Speed at which the ball touches the wall [m/s].
  double touch_speed(const Wall& wall, double approach) const {
    const double touch = rules_.touch_speed(body_.radius, body_.mass, approach);
    if (!rules_.liquid || rules_.sustained_mode != SustainedContactMode::tc) return touch;
    return TcRule{rules_.contact_time, rules_.sustained_friction}.wet_approach(
        approach, touch, mill_time() - last_contact_time_, pressing_acceleration(wall));
  }
  /// Collision by the wall's rule (evt.6 to evt.8), or by the TC rule (man.4).
  Bounce bounce(int face, const Wall& wall, double approach, double slip) {
    const contact::BounceRule& rule = rules_.wall(face);
    if (rules_.sustained_mode != SustainedContactMode::tc) {
      const contact::Impulse j = contact::bounce(
          rule, body_.mass, approach, slip, rule.restitution.at(approach), body_.slip_factor());
      return {j, contact::loss(j, body_.mass, approach, slip, body_.slip_factor())};
    }
    const double since = mill_time() - last_contact_time_;
    const TcRule tc_rule{rules_.contact_time, rules_.sustained_friction};
    StoredEnergy stored(stored_, tc_rule.storage_capacity(body_.mass, pressing_acceleration_));
    auto b = tc_rule.collide(rule, {body_.mass, approach, slip, since, pressing_acceleration(wall),
                                    stored.sum(), body_.slip_factor()});
    stored.update(b);
    if (b.raised) ++energy_balance_.tc_collisions;
    energy_balance_.withheld += b.withheld;
    if (since < rules_.contact_time) {
      energy_balance_.lost_within += b.loss.normal + b.loss.tangential;
      if (approach >= rules_.threshold) ++energy_balance_.hits_within;
    }
    return {b.impulse, b.loss, b.stored_change, b.raised};
  }

  void record(int face, const Wall& wall, const Vec3& n, double approach, double slip, double glide,
              double impulse, const contact::Loss& loss) {
    const double t = mill_time();
    finished_.push_back({.time = t - start_,
                         .duration = 0,
                         .ball = 0,
                         .other = ~face,
                         .where = jar_.to_jar_axes(wall.point, t),
                         .normal = jar_.to_jar_axes(n, t),
                         .mass = body_.mass,
                         .approach = approach,
                         .slip = slip,
                         .glide = glide,
                         .impulse = impulse,
                         .lost_normal = loss.normal,
                         .lost_tangential = loss.tangential});
  }

  /// Whether the coming bounces on `face` collapse into a sustained contact (evt.19).
  bool collapses(int face) const {
    if (rules_.sustained_mode != SustainedContactMode::roll || rebound_ >= rules_.sustained_speed)
      return false;
    const BallState& p = now_.ball;
    const double pressing =
        integrator_.contact().normal_acceleration(face, now_.time, p.position, p.velocity);
    const double rate = jar_.motion_bounds().jerk + jar_.motion_bounds().spin * pressing +
                        pressing * norm(p.velocity) / body_.radius;
    const double touch = rules_.touch_speed(body_.radius, body_.mass, rebound_);
    double restitution = rules_.wall(face).restitution.at(touch);
    if (touch < rebound_) restitution *= touch / rebound_;
    return bounces_collapse(rebound_, restitution, pressing, rate, tolerance_.grazing_depth());
  }

  /// Begins a sustained contact; the remaining normal speed is lost.
  void begin_contact(int face) {
    BallState p = now_.ball;
    SupportFaces support;
    support.add(face);
    for (int other = 0; other < S::faces && support.count < SupportFaces::max_count; ++other)
      if (other != face && jar_.shape().can_touch(other, body_.radius) && rests_on(other, p))
        support.add(other);
    const double before = kinetic(p.velocity + now_.frame.velocity, spin_);
    double work = 0;
    for (std::size_t i = 0; i < support.count; ++i) {
      const Wall wall = jar_.wall(support.face[i], p.position, now_.time, body_.radius);
      const Vec3 n = -wall.inward, relative_velocity = p.velocity - wall.velocity;
      work += apply_impulse(-body_.mass * dot(relative_velocity, n) * n, wall, p);
    }
    energy_balance_.wall_work += work;
    energy_balance_.lost_lasting +=
        before + work - kinetic(p.velocity + now_.frame.velocity, spin_);
    ++energy_balance_.lasting_contacts;
    integrator_.begin(support, now_.time, {p.position, p.velocity, spin_, 0, 0});
    in_contact_ = in_contact_until_now_ = true;
  }

  /// Whether the ball also rests on another face: the ball touches the face, has hardly any normal
  /// speed, and is pressed to the face.
  bool rests_on(int face, const BallState& p) const {
    const Wall wall = jar_.wall(face, p.position, now_.time, body_.radius);
    return wall.gap <= 8 * tolerance_.margin &&
           std::abs(dot(p.velocity - wall.velocity, wall.inward)) < rules_.sustained_speed &&
           integrator_.contact().normal_acceleration(face, now_.time, p.position, p.velocity) > 0;
  }

  void advance_contact() {
    const double from = now_.time;
    using Status = typename SustainedContactIntegrator<TypedChamber<S, M>>::Status;
    const Status status = integrator_.advance(now_.time);
    energy_balance_.contact_time += now_.time - from;
    energy_balance_.wall_work += integrator_.state().work;
    energy_balance_.lost_lasting += integrator_.state().lost;
    integrator_.state().work = integrator_.state().lost = 0;
    if (status != Status::in_contact) {
      in_contact_ = false;
      spin_ = integrator_.state().spin;
      now_.frame = jar_.motion().frame_motion(now_.time);
      start_flight({integrator_.state().position, integrator_.state().velocity});
      last_contact_time_ = mill_time();
    }
    check_zeno();
    wrap_clock();
  }

  void wrap_clock() {
    if (now_.time < clock_range_) return;
    now_.time -= clock_range_;
    flight_.since -= clock_range_;
    clock_origin_ += clock_range_;
  }
  double mill_time() const { return clock_origin_ + now_.time; }

  /// Zeno guard: stops a run whose events accumulate in almost no time, with the reason.
  void check_zeno() {
    constexpr int many = 100000;
    constexpr double min_span = 0.01;  // [s]
    if (++zeno_count_ < many) return;
    if (mill_time() - zeno_since_ < min_span)
      throw zeno_error(mill_time() - start_, mill_time() - zeno_since_, many,
                       rules_.sustained_mode);
    zeno_count_ = 0;
    zeno_since_ = mill_time();
  }

  void hand_over(scene::Observer& observer) {
    if (!finished_.empty()) observer.collisions(finished_);
    finished_.clear();
  }

  TypedChamber<S, M> jar_;
  BallBody body_;
  Rules rules_;
  TouchTolerance tolerance_;
  SustainedContactIntegrator<TypedChamber<S, M>> integrator_;
  Flight flight_;
  Vec3 spin_;
  bool in_contact_ = false;
  bool in_contact_until_now_ = false;  // the ball came here in sustained contact, not in flight
  // [m/s2] largest acceleration with which the mill presses a ball to its wall (man.4)
  double pressing_acceleration_;
  double start_;                                 // [s] mill time at which the run began
  Instant now_;                                  // its time is on the engine's clock
  double clock_origin_ = 0;                      // [s] mill time = clock_origin_ + clock
  double clock_range_ = kinematics::no_period;   // [s] the clock's range
  double reached_ = 0;                           // [s] since the start
  double stored_ = 0;                            // [J] of earlier losses, for the TC rule (man.6)
  double rebound_ = 0;                           // [m/s] after the last collision
  double last_contact_time_ = -geometry::never;  // [s] mill time of the last collision or release
  int zeno_count_ = 0;
  double zeno_since_ = 0;
  scene::EnergyBalance energy_balance_;
  std::vector<scene::Collision> finished_;
};

}  // namespace mahlwerk::event
