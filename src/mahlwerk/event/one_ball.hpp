// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "mahlwerk/event/guard.hpp"
#include "mahlwerk/event/search.hpp"
#include "mahlwerk/event/stay.hpp"
#include "mahlwerk/event/sustained_contact.hpp"
#include "mahlwerk/kinematics/strongest_field.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::event {

/// The event engine for one ball: flight, touch, bounce, and lasting contact where bounces
/// collapse. The clock runs within one period of the mill, so that late times are as exact as early
/// ones.
template <class S, class M>
class OneBall final : public scene::Engine {
 public:
  OneBall(const Jar<S, M>& jar, const scene::Ball& ball, const Rules& rules, double start)
      : jar_(jar),
        body_{ball.radius, ball.mass(), ball.inertia()},
        rules_(rules),
        feeler_(feeler(jar_, ball.radius)),
        stay_(jar_, body_, rules, feeler_),
        spin_(ball.spin),
        field_(kinematics::strongest_field(jar_.gravity(), jar_.limits().acceleration,
                                           jar_.motion().period(),
                                           [&](double t) { return jar_.motion().ride(t); })),
        start_(start) {
    const double period = jar_.looks_still() ? jar_.motion().period() : kinematics::no_period;
    round_ = period;
    before_ = std::isfinite(period) ? std::floor(start / period) * period : 0.0;
    now_.time = start - before_;
    now_.ride = jar_.motion().ride(now_.time);
    fly({ball.position, ball.velocity});
    account_.kinetic = kinetic(flight_.velocity);
    account_.potential = potential(flight_.position);
    account_.started_with = account_.kinetic + account_.potential;
    finished_.reserve(chunk);
  }

  void advance(double time, scene::Observer& observer) override {
    const double until = time + start_;
    try {
      while (mill_time() < until) {
        if (stopped()) {
          reached_ = std::max(reached_, mill_time() - start_);
          return hand_over(observer);
        }
        if (staying_) {
          linger();
          continue;
        }
        const Touch touch = next_touch(jar_, flight_, now_, until - before_, feeler_);  // (evt.3)
        account_.search_steps += touch.steps;
        now_ = touch.when;
        if (touch.face < 0) {
          if (!(now_.time < until - before_)) break;
          guarded_ += static_cast<int>(touch.steps / 16);
          guard();
          continue;
        }
        collide(touch.face);  // (evt.6) to (evt.8)
        if (collapses(touch.face)) settle(touch.face);
        guard();
        turn_back_clock();
        if (finished_.size() >= chunk) hand_over(observer);
      }
    } catch (...) {
      reached_ = mill_time() - start_;
      hand_over(observer);
      throw;
    }
    reached_ = time;
    hand_over(observer);
  }

  scene::Account account() const override {
    scene::Account a = account_;
    const double at = staying_ ? now_.time : reached_ + start_ - before_;
    // Never a rounding below what was asked for: whoever waits for it would wait for ever.
    a.time = staying_ ? std::max(reached_, before_ + at - start_) : reached_;
    const kinematics::Ride ride = jar_.motion().ride(at);
    const Vec3& g = jar_.gravity();
    const Vec3 place = staying_ ? stay_.now().position + ride.centre : flight_.lab_position(at, g);
    const Vec3 speed =
        staying_ ? stay_.now().velocity + ride.velocity : flight_.lab_velocity(at, g);
    a.kinetic = kinetic(speed);
    a.potential = potential(place);
    return a;
  }

  std::vector<scene::Ball> balls() const override {
    const double at = staying_ ? now_.time : reached_ + start_ - before_;
    const Passing p = staying_ ? Passing{stay_.now().position, stay_.now().velocity}
                               : flight_.passing(at, jar_.gravity(), jar_.motion().ride(at));
    const double density = body_.mass / (4.0 / 3.0 * std::numbers::pi * std::pow(body_.radius, 3));
    return {{body_.radius, density, p.position, p.velocity, staying_ ? stay_.now().spin : spin_}};
  }

  void carry(Archive& archive) override {
    archive(flight_)(spin_)(staying_)(now_)(before_)(reached_)(stored_)(rebound_)(last_);
    archive(guarded_)(guarded_since_)(account_);
    stay_.carry(archive);
  }

 private:
  static constexpr std::size_t chunk = 256;

  static Feeler feeler(const Jar<S, M>& jar, double radius) {
    const auto& limits = jar.limits();
    const double scale =
        jar.shape().reach() + norm(jar.motion().ride(0).centre) +
        (limits.jerk > 0 ? limits.speed * limits.speed / (norm(limits.acceleration) + 1e-300)
                         : 0.0);
    return {radius, std::max(1e-12 * radius, 64 * 0x1p-52 * scale)};
  }

  double kinetic(const Vec3& lab_velocity) const {
    return 0.5 * body_.mass * squared(lab_velocity) +
           0.5 * body_.inertia * squared(staying_ ? stay_.now().spin : spin_);
  }
  double potential(const Vec3& lab_position) const {
    return -body_.mass * dot(jar_.gravity(), lab_position);
  }

  /// Flight begins now, with the ball relative to the jar as said.
  void fly(const Passing& p) {
    now_.ball = p;
    flight_ = {now_.time, p.position + now_.ride.centre, p.velocity + now_.ride.velocity};
  }

  /// An impulse of the wall on the ball: the ball's velocity and spin, and the work of the wall
  /// [J].
  double push(const Vec3& impulse, const Wall& wall, Passing& p) {
    p.velocity += impulse / body_.mass;
    spin_ -= body_.radius / body_.inertia * cross(wall.inward, impulse);
    return dot(impulse, now_.ride.velocity + wall.velocity);
  }

  [[gnu::flatten]] void collide(int face) {
    const double m = body_.mass, r = body_.radius;
    const Wall wall = jar_.wall(face, now_.ball.position, now_.time, r);
    const Vec3 n = -wall.inward, glide = now_.ball.velocity - wall.velocity;
    const double approach = dot(glide, n);
    account_.deepest_overlap = std::max(account_.deepest_overlap, -wall.gap / r);
    const Vec3 gliding = glide - approach * n, slipping = gliding + r * cross(spin_, n);
    const double slip = norm(slipping);

    const auto [j, loss, kept] = bounce(face, wall, approach, slip);
    refuse_gain(loss, m, approach, slip, mill_time() - start_);
    const Vec3 impulse = -j.normal * n - (slip > 0 ? j.tangential / slip : 0.0) * slipping;

    Passing after = now_.ball;
    const double before = kinetic(after.velocity + now_.ride.velocity);
    const double work = push(impulse, wall, after);
    const double gained = kinetic(after.velocity + now_.ride.velocity) - before;
    check_balance(gained, work, loss.normal + loss.tangential + kept, before);

    account_.wall_work += work;
    account_.lost_normal += loss.normal;
    account_.lost_tangential += loss.tangential;
    account_.elastic += kept;
    ++account_.collisions;
    record(face, wall, n, approach, slip, norm(gliding), j.normal, loss);
    rebound_ = j.normal / m - approach;
    last_ = mill_time();
    fly(after);
  }

  struct Bounce {
    contact::Impulse impulse;
    contact::Loss loss;
    double kept = 0;  ///< [J] that is stored after it, more than before (man.6)
  };
  /// By the wall's rule (evt.6 to evt.8), or that of sustained contacts under the TC rule (man.4).
  Bounce bounce(int face, const Wall& wall, double approach, double slip) {
    const contact::BounceRule& rule = rules_.wall(face);
    if (rules_.lasting != Lasting::tc) {
      const contact::Impulse j = contact::bounce(rule, body_.mass, approach, slip);
      return {j, contact::loss(j, body_.mass, approach, slip)};
    }
    const double since = mill_time() - last_;
    const double round =
        squared(across(now_.ball.velocity, wall.inward)) * std::max(wall.bend, 0.0);
    const SustainedContact sustained{rules_.contact_time, rules_.lasting_friction};
    StoredEnergy stored(stored_, sustained.room(body_.mass, field_));
    auto b =
        sustained.collide(rule, {body_.mass, approach, slip, since, field_ + round, stored.sum()});
    stored.settle(b);
    if (b.raised) ++account_.tc_collisions;
    account_.withheld += b.withheld;
    if (since < rules_.contact_time) {
      account_.lost_within += b.loss.normal + b.loss.tangential;
      if (approach >= rules_.threshold) ++account_.hits_within;
    }
    return {b.impulse, b.loss, b.kept};
  }

  void check_balance(double gained, double work, double lost, double scale) {
    const double residual =
        std::abs(gained - work + lost) / (scale + std::abs(work) + std::abs(lost) + 1e-300);
    if (!(residual <= account_.worst_collision)) account_.worst_collision = residual;
  }

  void record(int face, const Wall& wall, const Vec3& n, double approach, double slip, double glide,
              double impulse, const contact::Loss& loss) {
    const double t = mill_time();
    finished_.push_back({.time = t - start_,
                         .duration = 0,
                         .ball = 0,
                         .other = ~face,
                         .where = jar_.own(wall.point, t),
                         .normal = jar_.own(n, t),
                         .mass = body_.mass,
                         .approach = approach,
                         .slip = slip,
                         .glide = glide,
                         .impulse = impulse,
                         .lost_normal = loss.normal,
                         .lost_tangential = loss.tangential});
  }

  /// Whether the bounces that follow would all be over before the wall's hold on the ball has
  /// changed: then they are countless and the ball has come to stay (evt.19).
  bool collapses(int face) const {
    if (rules_.lasting != Lasting::roll || rebound_ >= rules_.lasting_speed) return false;
    const Passing& p = now_.ball;
    const double press = stay_.contact().press(face, now_.time, p.position, p.velocity);
    if (press <= 0) return false;
    const double e = rules_.wall(face).restitution.at(rebound_);
    const double over_in = 2 * rebound_ / (press * (1 - e));  // [s]
    const double change =
        jar_.limits().jerk + jar_.limits().spin * press + press * norm(p.velocity) / body_.radius;
    return over_in * change < 0.5 * press;
  }

  /// Contact begins: what normal speed is left is lost.
  void settle(int face) {
    Passing p = now_.ball;
    Seat seat;
    seat.join(face);
    for (int other = 0; other < S::faces && seat.count < Seat::most; ++other)
      if (other != face && jar_.shape().meets(other, body_.radius) && pinned(other, p))
        seat.join(other);
    const double before = kinetic(p.velocity + now_.ride.velocity);
    double work = 0;
    for (std::size_t i = 0; i < seat.count; ++i) {
      const Wall wall = jar_.wall(seat.face[i], p.position, now_.time, body_.radius);
      const Vec3 n = -wall.inward, glide = p.velocity - wall.velocity;
      work += push(-body_.mass * dot(glide, n) * n, wall, p);
    }
    account_.wall_work += work;
    account_.lost_lasting += before + work - kinetic(p.velocity + now_.ride.velocity);
    ++account_.lasting_contacts;
    stay_.begin(seat, now_.time, {p.position, p.velocity, spin_, 0, 0});
    staying_ = true;
  }

  /// Whether the ball also rests on another face: it touches it, hardly moves to or from it, and is
  /// pressed.
  bool pinned(int face, const Passing& p) const {
    const Wall wall = jar_.wall(face, p.position, now_.time, body_.radius);
    return wall.gap <= 8 * feeler_.margin &&
           std::abs(dot(p.velocity - wall.velocity, wall.inward)) < rules_.lasting_speed &&
           stay_.contact().press(face, now_.time, p.position, p.velocity) > 0;
  }

  void linger() {
    const double from = now_.time;
    using Verdict = typename Stay<Jar<S, M>>::Verdict;
    const Verdict verdict = stay_.advance(now_.time);
    account_.contact_time += now_.time - from;
    account_.wall_work += stay_.now().work;
    account_.lost_lasting += stay_.now().lost;
    stay_.now().work = stay_.now().lost = 0;
    if (verdict != Verdict::staying) {
      staying_ = false;
      spin_ = stay_.now().spin;
      now_.ride = jar_.motion().ride(now_.time);
      fly({stay_.now().position, stay_.now().velocity});
      last_ = mill_time();
    }
    guard();
    turn_back_clock();
  }

  void turn_back_clock() {
    if (now_.time < round_) return;
    now_.time -= round_;
    flight_.since -= round_;
    before_ += round_;
  }
  double mill_time() const { return before_ + now_.time; }

  /// A run whose events pile up without end stops with the reason, rather than hang.
  void guard() {
    constexpr int many = 100000;
    constexpr double soon = 0.01;  // [s]
    if (++guarded_ < many) return;
    if (mill_time() - guarded_since_ < soon)
      throw pile_up(mill_time() - start_, mill_time() - guarded_since_, many, rules_.lasting);
    guarded_ = 0;
    guarded_since_ = mill_time();
  }

  void hand_over(scene::Observer& observer) {
    if (!finished_.empty()) observer.collisions(finished_);
    finished_.clear();
  }

  Jar<S, M> jar_;
  BallBody body_;
  Rules rules_;
  Feeler feeler_;
  Stay<Jar<S, M>> stay_;
  Flight flight_;
  Vec3 spin_;
  bool staying_ = false;
  double field_;                          // [m/s2] the strongest of the mill (man.4)
  double start_;                          // [s] of the mill's own time
  Instant now_;                           // its time is the clock's
  double before_ = 0;                     // [s] mill time = before_ + clock
  double round_ = kinematics::no_period;  // [s] the clock's range
  double reached_ = 0;                    // [s] since the start
  double stored_ = 0;                     // [J] of earlier losses, for the TC rule (man.6)
  double rebound_ = 0;                    // [m/s] after the last collision
  double last_ = -geometry::never;        // [s] mill time of the last event
  int guarded_ = 0;
  double guarded_since_ = 0;
  scene::Account account_;
  std::vector<scene::Collision> finished_;
};

}  // namespace mahlwerk::event
