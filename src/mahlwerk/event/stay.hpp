// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/event/lasting.hpp"
#include "mahlwerk/event/search.hpp"

// One step of a lasting contact: Dormand and Prince's embedded pair of orders 5 and 4, with its
// step chosen from the error (evt.18).
namespace mahlwerk::event {

struct Stride {
  Rest end, rate;    ///< the state at its end, and its derivative there
  Reaction forces;   ///< there
  double error = 0;  ///< relative to what is allowed; the step is good up to 1
};

/// `rate(t, y, forces)` is the derivative; `first` its value at the start.
template <class Rate>
Stride stride(const Rate& rate, double t, const Rest& y, const Rest& first, double h,
              double radius) {
  const Rest& a = first;
  Reaction forces;
  const Rest b = rate(t + h / 5, y + h / 5 * a, forces);
  const Rest c = rate(t + 3 * h / 10, y + h * (3.0 / 40 * a + 9.0 / 40 * b), forces);
  const Rest d =
      rate(t + 4 * h / 5, y + h * (44.0 / 45 * a + -56.0 / 15 * b + 32.0 / 9 * c), forces);
  const Rest e = rate(
      t + 8 * h / 9,
      y + h * (19372.0 / 6561 * a + -25360.0 / 2187 * b + 64448.0 / 6561 * c + -212.0 / 729 * d),
      forces);
  const Rest f = rate(t + h,
                      y + h * (9017.0 / 3168 * a + -355.0 / 33 * b + 46732.0 / 5247 * c +
                               49.0 / 176 * d + -5103.0 / 18656 * e),
                      forces);
  const Rest end = y + h * (35.0 / 384 * a + 500.0 / 1113 * c + 125.0 / 192 * d +
                            -2187.0 / 6784 * e + 11.0 / 84 * f);
  const Rest last = rate(t + h, end, forces);
  const Rest wrong = h * (71.0 / 57600 * a + -71.0 / 16695 * c + 71.0 / 1920 * d +
                          -17253.0 / 339200 * e + 22.0 / 525 * f + -1.0 / 40 * last);
  constexpr double relative = 1e-8;
  const double speed = norm(end.velocity) + radius * norm(end.spin) + 1e-3;  // [m/s] floor
  const double error = std::max({norm(wrong.position) / (relative * radius),
                                 norm(wrong.velocity) / (relative * speed),
                                 radius * norm(wrong.spin) / (relative * speed)});
  return {end, last, forces, error};
}

/// Drives a ball that stays on the wall until it leaves or time is up.
template <class J>
class Stay {
 public:
  enum class Verdict { staying, released, touched };

  Stay(const J& jar, const BallBody& ball, const Rules& rules, const Feeler& feeler)
      : jar_(&jar), contact_(jar, ball, rules), ball_(ball), rules_(rules), feeler_(feeler) {}

  /// Begins at `t` with the ball on the faces of `seat`; grip is found out.
  void begin(Seat seat, double t, const Rest& y) {
    seat_ = seat;
    now_ = y;
    step_ = 1e-5;
    known_ = false;
    if (seat_.count == 1) choose_grip(t);
  }

  /// One step from `t`, which it moves on. `now()` is the state after it.
  Verdict advance(double& t) {
    const auto rate = [this](double at, const Rest& y, Reaction& forces) {
      return contact_.rate(seat_, at, y, forces);
    };
    if (seat_.count == 1 && seat_.grip == Grip::creeping && apart(t)) begin(seat_, t, now_);
    if (!known_) rate_ = rate(t, now_, forces_);
    if (seat_.grip != Grip::creeping && regrip(t)) rate_ = rate(t, now_, forces_);
    if (let_go(t)) return Verdict::released;

    const double crease = until_crease(t);
    const double wanted = std::min({step_, slide_limit(), clear_of_others(t), crease});
    double h = wanted;
    Stride s = stride(rate, t, now_, rate_, h, ball_.radius);
    while (!(s.error <= 1)) {
      h *= s.error > 1 ? std::clamp(0.9 * std::pow(s.error, -0.2), 0.1, 0.9) : 0.1;
      s = stride(rate, t, now_, rate_, h, ball_.radius);
    }
    if (h < wanted ||
        wanted == step_)  // a step cut short for other reasons says nothing about the error
      step_ = h * std::clamp(0.9 * std::pow(s.error + 1e-12, -0.2), 0.2, 3.0);
    if (leaves(t + h, s)) {
      h = moment_of_leaving(rate, t, h);
      s = stride(rate, t, now_, rate_, h, ball_.radius);
    }
    t += h;
    now_ = s.end;
    rate_ = s.rate;
    forces_ = s.forces;
    known_ = h < crease;  // beyond it the derivative is another
    contact_.seat_exactly(seat_, t, now_);
    return bounces_off_other(t) ? Verdict::touched : Verdict::staying;
  }

  void carry(Archive& archive) {
    archive(seat_)(now_)(rate_)(forces_)(known_)(step_);
    if (seat_.count > Seat::most) throw Archive::broken();
  }

  const Rest& now() const { return now_; }
  Rest& now() { return now_; }
  const Seat& seat() const { return seat_; }
  const LastingContact<J>& contact() const { return contact_; }

 private:
  static constexpr double sticking_speed = 1e-4;  // [m/s] slip below it may come to rest
  static constexpr double unnoticed = 3e-5;       // [s] in which no mill changes its push much

  void choose_grip(double t) {
    const double mu = rules_.lasting_friction;
    const bool slips = norm(contact_.slip(seat_.face[0], t, now_)) > sticking_speed;
    seat_.grip = mu == 0 || (slips && std::isfinite(mu)) ? Grip::sliding : Grip::rolling;
    if (seat_.grip == Grip::rolling) contact_.stick(seat_.face[0], t, now_);
    contact_.seat_exactly(seat_, t, now_);
  }

  /// Rolling that needs more friction than there is begins to slide; sliding that has come to rest
  /// rolls.
  bool regrip(double t) {
    const double mu = rules_.lasting_friction;
    if (mu == 0 || std::isinf(mu)) return false;
    const double most = mu * std::max(forces_.press[0], 0.0), needed = norm(forces_.wanted);
    if (seat_.grip == Grip::rolling && needed > most) {
      seat_.grip = Grip::sliding;
      return true;
    }
    if (seat_.grip == Grip::sliding && needed <= most && norm(forces_.slip) <= sticking_speed) {
      seat_.grip = Grip::rolling;
      contact_.stick(seat_.face[0], t, now_);
      contact_.seat_exactly(seat_, t, now_);
      return true;
    }
    return false;
  }

  /// A ball whose slip is coming to rest nears that moment from this side (evt.14).
  double slide_limit() const {
    if (seat_.grip != Grip::sliding) return geometry::never;
    const double speed = norm(forces_.slip);
    if (speed <= sticking_speed) return geometry::never;
    const double slowing =
        3.5 * dot(forces_.wanted - forces_.drag, forces_.slip) / speed;  // [m/s2]
    return slowing > 0 ? 0.9 * speed / slowing : geometry::never;
  }

  /// Steps end where the curvature jumps, for across it the derivative is not smooth: just before,
  /// and after one of at most `short_way` just beyond. The way there is nearly straight only when
  /// it is short, so a long one is not gone at once.
  double until_crease(double t) const {
    constexpr double short_way = 1e-8;  // [s]
    double soonest = geometry::never;
    for (std::size_t i = 0; i < seat_.count; ++i) {
      const int face = seat_.face[i];
      double time = jar_->until_crease(face, {now_.position, now_.velocity}, t);
      if (time < step_)  // halfway the velocity is the mean one
        time = jar_->until_crease(face,
                                  {now_.position, now_.velocity + 0.5 * time * rate_.velocity}, t);
      soonest = std::min(soonest, time > short_way ? 0.9 * time : time + least_step());
    }
    return std::max(soonest, least_step());
  }

  double least_step() const { return feeler_.least_step(norm(now_.velocity) + jar_->sweep()); }

  /// Calls `look(face)` for every face that the ball could touch besides those it rests on.
  template <class Look>
  void for_each_other(const Look& look) const {
    for (int face = 0; face < jar_->shape().faces; ++face)
      if (!seat_.has(face) && jar_->shape().meets(face, ball_.radius)) look(face);
  }

  /// A step in which no other face is touched, or so slowly that it would be no bounce: a ball that
  /// has just left a face, or lies beside it, must not crawl.
  double clear_of_others(double t) const {
    double clear = geometry::never;
    for_each_other([&](int face) {
      double time = std::max(outlook(face, t, now_).time, least_step());
      if (time < unnoticed) time = std::max(time, slowly(face, t));
      clear = std::min(clear, time);
    });
    return clear;
  }

  /// A time in which the ball gains less than `lasting_speed` towards a face at twice its present
  /// acceleration against it [s].
  double slowly(int face, double t) const {
    const auto hold = jar_->hold(face, {now_.position, now_.velocity}, t);
    const double against = std::abs(dot(rate_.velocity, hold.inward) - hold.bend);
    return rules_.lasting_speed / (2 * against + rules_.lasting_speed / unnoticed);
  }

  /// Whether the ball is so far from all faces but its own that it no longer has to creep.
  bool apart(double t) const {
    bool apart = true;
    for_each_other(
        [&](int face) { apart = apart && outlook(face, t, now_).gap > 1e-3 * ball_.radius; });
    return apart;
  }

  /// Whether another face is touched fast enough to bounce. One touched slower holds the ball from
  /// now on too, or lets it go as soon as its reaction is known.
  bool bounces_off_other(double t) {
    bool bounces = false;
    for_each_other([&](int face) {
      const geometry::Outlook look = outlook(face, t, now_);
      if (look.gap <= 2 * feeler_.margin && look.closing > 0 && !joined(face, t)) bounces = true;
    });
    return bounces;
  }

  /// The face is touched; if slowly, what is left of the normal speed is lost and the face joins.
  bool joined(int face, double t) {
    const Wall wall = jar_->wall(face, now_.position, t, ball_.radius);
    const double closing = dot(wall.velocity - now_.velocity, wall.inward);
    if (closing >= rules_.lasting_speed || seat_.count == Seat::most) return false;
    const Vec3 change = closing * wall.inward;
    const double before = contact_.energy(t, now_);
    const double work = ball_.mass * dot(change, jar_->motion().ride(t).velocity + wall.velocity);
    now_.velocity += change;
    now_.work += work;
    now_.lost += before + work - contact_.energy(t, now_);
    seat_.join(face);
    known_ = false;
    return true;
  }
  geometry::Outlook outlook(int face, double t, const Rest& y) const {
    return jar_->outlook(face, {y.position, y.velocity}, t, ball_.radius - feeler_.margin);
  }

  /// The wall would have to pull. Where several hold the ball it leaves the one that would have to
  /// pull most, and may stay on the others.
  bool let_go(double t) {
    while (forces_.pulls(seat_)) {
      if (seat_.count == 1) return true;
      seat_.leave(forces_.least(seat_));
      rate_ = contact_.rate(seat_, t, now_, forces_);
    }
    return false;
  }

  /// Whether a step ends with a wall that pulls or with the ball through another face.
  bool leaves(double t, const Stride& s) const {
    bool through = false;
    for_each_other([&](int face) {
      const geometry::Outlook look = outlook(face, t, s.end);
      through = through || (look.gap < 0 && look.closing > 0);
    });
    return through || s.forces.pulls(seat_);
  }

  /// The length of the step at whose end the ball has just left, by bisection: `leaves` is no
  /// smooth function.
  template <class Rate>
  double moment_of_leaving(const Rate& rate, double t, double h) const {
    double stays = 0, gone = h;
    for (int i = 0; i < 60 && gone - stays > least_step(); ++i) {
      const double middle = 0.5 * (stays + gone);
      const Stride s = stride(rate, t, now_, rate_, middle, ball_.radius);
      (leaves(t + middle, s) ? gone : stays) = middle;
    }
    return gone;
  }

  const J* jar_;
  LastingContact<J> contact_;
  BallBody ball_;
  Rules rules_;
  Feeler feeler_;
  Seat seat_;
  Rest now_;
  Rest rate_;  // derivative of now_, and the forces in it, if known_
  Reaction forces_;
  bool known_ = false;
  double step_ = 1e-5;  // [s] what the error asks for
};

}  // namespace mahlwerk::event
