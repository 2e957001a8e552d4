// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "mahlwerk/event/lasting.hpp"
#include "mahlwerk/event/search.hpp"

// One step of a lasting contact: Dormand and Prince's embedded pair of orders 5 and 4, with its step chosen
// from the error (evt.18).
namespace mahlwerk::event {

struct Stride {
  Rest end;
  double error = 0;  ///< relative to what is allowed; the step is good up to 1
};

/// `rate(t, y)` is the derivative; `first` its value at the start.
template <class Rate>
Stride stride(const Rate& rate, double t, const Rest& y, const Rest& first, double h, double radius) {
  const Rest& a = first;
  const Rest b = rate(t + h / 5, y + h / 5 * a);
  const Rest c = rate(t + 3 * h / 10, y + h * (3.0 / 40 * a + 9.0 / 40 * b));
  const Rest d = rate(t + 4 * h / 5, y + h * (44.0 / 45 * a + -56.0 / 15 * b + 32.0 / 9 * c));
  const Rest e = rate(t + 8 * h / 9, y + h * (19372.0 / 6561 * a + -25360.0 / 2187 * b +
                                              64448.0 / 6561 * c + -212.0 / 729 * d));
  const Rest f = rate(t + h, y + h * (9017.0 / 3168 * a + -355.0 / 33 * b + 46732.0 / 5247 * c +
                                      49.0 / 176 * d + -5103.0 / 18656 * e));
  const Rest end = y + h * (35.0 / 384 * a + 500.0 / 1113 * c + 125.0 / 192 * d +
                            -2187.0 / 6784 * e + 11.0 / 84 * f);
  const Rest last = rate(t + h, end);
  const Rest wrong = h * (71.0 / 57600 * a + -71.0 / 16695 * c + 71.0 / 1920 * d +
                          -17253.0 / 339200 * e + 22.0 / 525 * f + -1.0 / 40 * last);
  constexpr double relative = 1e-8;
  const double speed = norm(end.velocity) + radius * norm(end.spin) + 1e-3;  // [m/s] floor
  const double error =
      std::max({norm(wrong.position) / (relative * radius),
                norm(wrong.velocity) / (relative * speed),
                radius * norm(wrong.spin) / (relative * speed)});
  return {end, error};
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
    if (seat_.count == 1) choose_grip(t);
  }

  /// One step from `t`, which it moves on. `now()` is the state after it.
  Verdict advance(double& t) {
    Reaction forces;
    const auto rate = [&](double at, const Rest& y) {
      Reaction ignored;
      return contact_.rate(seat_, at, y, ignored);
    };
    Rest first = contact_.rate(seat_, t, now_, forces);
    if (seat_.count == 1 && regrip(t, forces)) first = contact_.rate(seat_, t, now_, forces);
    if (let_go(forces, t)) return Verdict::released;

    double h = std::min({step_, slide_limit(forces), clear_of_others(t)});
    Stride s = stride(rate, t, now_, first, h, ball_.radius);
    while (s.error > 1 || !(s.error >= 0)) {
      h *= s.error >= 0 ? std::clamp(0.9 * std::pow(s.error, -0.2), 0.1, 0.9) : 0.1;
      s = stride(rate, t, now_, first, h, ball_.radius);
    }
    const double grown = h * std::clamp(0.9 * std::pow(s.error + 1e-12, -0.2), 0.2, 3.0);
    if (h == step_ || grown < step_) step_ = grown;  // not after a step cut short for other reasons
    if (leaves(t + h, s.end)) {
      h = moment_of_leaving(rate, t, first, h);
      s = stride(rate, t, now_, first, h, ball_.radius);
    }
    t += h;
    now_ = s.end;
    contact_.seat_exactly(seat_, t, now_);
    return touches_other(t) ? Verdict::touched : Verdict::staying;
  }

  const Rest& now() const { return now_; }
  Rest& now() { return now_; }
  const Seat& seat() const { return seat_; }
  const LastingContact<J>& contact() const { return contact_; }

 private:
  static constexpr double sticking_speed = 1e-6;  // [m/s] slip below it may come to rest

  void choose_grip(double t) {
    const double mu = rules_.lasting_friction();
    const bool slips = norm(contact_.slip(seat_.face[0], t, now_)) > sticking_speed;
    seat_.grip = mu == 0 || (slips && std::isfinite(mu)) ? Grip::sliding : Grip::rolling;
    contact_.seat_exactly(seat_, t, now_);
  }

  /// Rolling that needs more friction than there is begins to slide; sliding that has come to rest rolls.
  bool regrip(double t, const Reaction& f) {
    const double mu = rules_.lasting_friction();
    if (mu == 0 || std::isinf(mu)) return false;
    const double most = mu * std::max(f.press[0], 0.0);
    if (seat_.grip == Grip::rolling && f.needed > most && f.needed > 0) {
      seat_.grip = Grip::sliding;
      seat_.slide = -1.0 / f.needed * f.drag;
      return true;
    }
    if (seat_.grip == Grip::sliding && f.needed <= most && norm(f.slip) <= sticking_speed) {
      seat_.grip = Grip::rolling;
      contact_.seat_exactly(seat_, t, now_);
      return true;
    }
    return false;
  }

  /// A sliding ball approaches rest in halves, so that it does not slide past it.
  double slide_limit(const Reaction& f) const {
    const double mu = rules_.lasting_friction();
    if (seat_.count == 2 || seat_.grip != Grip::sliding || mu == 0) return geometry::never;
    const double fastest = 3.5 * (mu * std::max(f.press[0], 0.0) + f.needed);  // [m/s2] of the slip
    return std::max(0.5 * norm(f.slip) / fastest, 1e-8);
  }

  bool rests_on(int face) const {
    return seat_.face[0] == face || (seat_.count == 2 && seat_.face[1] == face);
  }
  double clear_of_others(double t) const {
    double clear = geometry::never;
    for (int face = 0; face < jar_->shape().faces; ++face)
      if (!rests_on(face) && jar_->shape().meets(face, ball_.radius))
        clear = std::min(clear, std::max(outlook(face, t, now_).time, 10 * feeler_.least_step));
    return clear;
  }
  bool touches_other(double t) const {
    for (int face = 0; face < jar_->shape().faces; ++face) {
      if (rests_on(face) || !jar_->shape().meets(face, ball_.radius)) continue;
      const geometry::Outlook look = outlook(face, t, now_);
      if (look.gap <= 2 * feeler_.margin && look.closing > 0) return true;
    }
    return false;
  }
  geometry::Outlook outlook(int face, double t, const Rest& y) const {
    return jar_->outlook(face, {y.position, y.velocity}, t, ball_.radius - feeler_.margin);
  }

  /// The wall would have to pull. From an edge the ball leaves one face and may stay on the other.
  bool let_go(const Reaction& f, double t) {
    if (seat_.count == 1) return f.press[0] < 0;
    if (f.press[0] >= 0 && f.press[1] >= 0) return false;
    const int kept = f.press[0] < f.press[1] ? seat_.face[1] : seat_.face[0];
    begin({1, {kept, 0}, Grip::rolling, {}}, t, now_);
    return contact_.press(kept, t, now_.position, now_.velocity) < 0;
  }

  /// Whether a step ends with a wall that pulls or with the ball through another face.
  bool leaves(double t, const Rest& y) const {
    Reaction f;
    contact_.rate(seat_, t, y, f);
    if (f.press[0] < 0 || (seat_.count == 2 && f.press[1] < 0)) return true;
    for (int face = 0; face < jar_->shape().faces; ++face)
      if (!rests_on(face) && jar_->shape().meets(face, ball_.radius) && outlook(face, t, y).gap < 0)
        return true;
    return false;
  }

  /// The length of the step at whose end the ball has just left, by bisection: `leaves` is no smooth function.
  template <class Rate>
  double moment_of_leaving(const Rate& rate, double t, const Rest& first, double h) const {
    double stays = 0, gone = h;
    for (int i = 0; i < 40 && gone - stays > 1e-9 * h + feeler_.least_step; ++i) {
      const double middle = 0.5 * (stays + gone);
      (leaves(t + middle, stride(rate, t, now_, first, middle, ball_.radius).end) ? gone : stays) =
          middle;
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
  double step_ = 1e-5;
};

}  // namespace mahlwerk::event
