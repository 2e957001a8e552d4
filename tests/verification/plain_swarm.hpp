// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <limits>
#include <variant>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/contact/bounce.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/chamber.hpp"
#include "statement.hpp"

namespace mahlwerk::tests {

/// Reference event engine for many balls, as simple as possible, in the laboratory frame. It tests
/// all pairs before every collision. After a collision it searches for wall touches by steps that
/// no ball and no wall is fast enough to cross, and by bisection. No cells, no event queue, no
/// falling frame.
class PlainSwarm {
 public:
  struct Bounce {
    double time = 0;  ///< [s]
    int ball = -1, other = -1;
    double approach = 0;  ///< [m/s]
  };

  /// After every collision both balls are displaced by `noise` [m] in a random direction.
  PlainSwarm(const scene::Chamber& chamber, const std::vector<scene::Ball>& balls,
             const contact::BounceRule& rule, double noise = 0, std::uint64_t seed = 0)
      : chamber_(chamber), balls_(balls), rule_(rule), noise_(noise), random_(seed, 0) {
    const kinematics::FrameMotion frame = frame_motion_at(0);
    for (scene::Ball& b : balls_) {
      b.position += frame.centre + jitter();
      b.velocity += frame.velocity;
    }
    walls_.resize(balls_.size());
    for (int i = 0; i < static_cast<int>(balls_.size()); ++i) ask_walls(i);
  }

  Bounce next() {
    Bounce first = earliest();
    for (double ahead = foresight(); first.time > now_ + ahead; first = earliest())
      go_to(now_ + ahead);
    go_to(first.time);
    first.approach = collide(ball(first.ball), first.other);
    ball(first.ball).position += jitter();
    ask_walls(first.ball);
    if (first.other >= 0) {
      ball(first.other).position += jitter();
      ask_walls(first.other);
    }
    return first;
  }

 private:
  scene::Ball& ball(int i) { return balls_[static_cast<std::size_t>(i)]; }
  Vec3 jitter() { return noise_ > 0 ? noise_ * random_.direction() : Vec3{}; }

  template <class Question>
  auto of_motion(Question question) const {
    return std::visit(question, *chamber_.motion);
  }
  kinematics::FrameMotion frame_motion_at(double t) const {
    return of_motion([t](const auto& m) { return m.frame_motion(t); });
  }
  int faces() const { return geometry::faces(*chamber_.shape); }
  Vec3 at(const scene::Ball& b, double s) const {
    return b.position + s * b.velocity + 0.5 * s * s * chamber_.gravity;
  }

  Bounce earliest() {
    Bounce first{std::numeric_limits<double>::infinity()};
    const int count = static_cast<int>(balls_.size());
    for (int i = 0; i < count; ++i)
      for (int j = i + 1; j < count; ++j)
        if (const double t = now_ + until_pair(ball(i), ball(j)); t < first.time) first = {t, i, j};
    for (int i = 0; i < count; ++i)
      if (const Bounce& b = walls_[static_cast<std::size_t>(i)]; b.time < first.time) first = b;
    return first;
  }
  void ask_walls(int i) { walls_[static_cast<std::size_t>(i)] = until_wall(i); }
  void go_to(double t) {
    for (scene::Ball& b : balls_) {
      b.position = in_box(at(b, t - now_));
      b.velocity += (t - now_) * chamber_.gravity;
    }
    now_ = t;
  }
  /// Time [s] within which no two balls pass from one periodic image to the next but one.
  double foresight() const {
    const Vec3 p =
        std::visit([](const auto& s) { return geometry::periods_of(s); }, *chamber_.shape);
    double fastest = 0;
    for (const scene::Ball& b : balls_) fastest = max_or_nan(fastest, norm(b.velocity));
    return std::min({p.x, p.y, p.z}) / (2 * fastest);
  }

  struct Contact {
    double gap = 0;           ///< [m]
    Vec3 inward, wall_speed;  ///< of the wall's material, in the laboratory
  };
  Contact wall(const scene::Ball& b, const Vec3& place, int face, double t) const {
    const kinematics::FrameMotion frame = frame_motion_at(t);
    const Rotation turn = of_motion([t](const auto& m) { return m.rotation(t); }) * chamber_.mount;
    const Vec3 spin = of_motion([t](const auto& m) { return m.spin(t); });
    const Vec3 here = place - frame.centre;
    const geometry::Gap gap = std::visit(
        [&](const auto& s) { return s.gap(face, turn.apply_inverse(here)); }, *chamber_.shape);
    const Vec3 inward = turn * gap.inward;
    return {gap.distance - b.radius, inward,
            frame.velocity + cross(spin, here - b.radius * inward)};
  }

  double until_pair(const scene::Ball& a, const scene::Ball& b) const {
    const Vec3 periods =
        std::visit([](const auto& s) { return geometry::periods_of(s); }, *chamber_.shape);
    const bool images = periods.x < geometry::never;
    double least = std::numeric_limits<double>::infinity();
    // Tests every periodic image in which the two balls can touch. Positions are not wrapped into
    // the box.
    const Vec3 apart = b.position - a.position;
    const auto nearest = [&](double x, double period) {
      return images ? std::rint(x / period) : 0;
    };
    const int far = images ? 2 : 0;
    for (int i = -far; i <= far; ++i)
      for (int j = -far; j <= far; ++j)
        for (int k = -far; k <= far; ++k) {
          Vec3 r = apart;
          if (images)
            r -= Vec3{periods.x * (i + nearest(apart.x, periods.x)),
                      periods.y * (j + nearest(apart.y, periods.y)),
                      periods.z * (k + nearest(apart.z, periods.z))};
          least = std::min(least, until_touch(r, b.velocity - a.velocity, a.radius + b.radius));
        }
    return least;
  }
  /// Time until |r + u s| = reach, from outside to inside.
  static double until_touch(const Vec3& r, const Vec3& u, double reach) {
    const double b = dot(r, u), d = b * b - squared(u) * (squared(r) - reach * reach);
    if (b >= 0 || d <= 0) return std::numeric_limits<double>::infinity();
    return std::max(0.0, (squared(r) - reach * reach) / (std::sqrt(d) - b));
  }

  /// The first touch of ball `i` with a wall. The search steps are at least a microsecond.
  Bounce until_wall(int i) {
    constexpr double longest = 1e-2, least = 1e-6;  // [s]
    const scene::Ball& b = ball(i);
    const kinematics::Bounds limits = of_motion([](const auto& m) { return m.bounds(); });
    const double reach = geometry::reach(*chamber_.shape);
    const auto touches = [&](double t, const Contact& c) {
      const Vec3 velocity = b.velocity + (t - now_) * chamber_.gravity;
      return c.gap <= 0 && dot(c.wall_speed - velocity, c.inward) > 0;
    };
    std::vector<int> met;
    for (int face = 0; face < faces(); ++face)
      if (std::visit([&](const auto& s) { return s.can_touch(face, b.radius); }, *chamber_.shape))
        met.push_back(face);
    double before = now_, after = now_;
    while (!met.empty()) {
      double free = std::numeric_limits<double>::infinity();
      Bounce first{free};
      for (const int face : met) {
        const auto look = [&](double t) { return wall(b, at(b, t - now_), face, t); };
        const Contact seen = look(after);
        free = std::min(free, seen.gap);
        if (!touches(after, seen)) continue;
        double low = before, high = after;
        for (int k = 0; k < 60; ++k) {  // bisection: closed and closing from `high` on
          const double middle = 0.5 * (low + high);
          (touches(middle, look(middle)) ? high : low) = middle;
        }
        if (high < first.time) first = {high, i, ~face};
      }
      if (first.ball >= 0) return first;
      const double most = norm(b.velocity + (after - now_) * chamber_.gravity) +
                          longest * norm(chamber_.gravity) + limits.speed + limits.spin * reach;
      before = after;
      after += std::clamp(free / most, least, longest);
    }
    return {std::numeric_limits<double>::infinity()};
  }

  /// Impulses of (evt.6) and (evt.7); returns the approach [m/s].
  double collide(scene::Ball& a, int other) {
    Vec3 n, u;  // from a to the contact; velocity of a's surface relative to the other's
    double mass = a.mass();
    scene::Ball* const b = other >= 0 ? &ball(other) : nullptr;
    if (b != nullptr) {
      n = toward(a, *b);
      u = a.velocity - b->velocity + cross(a.radius * a.spin + b->radius * b->spin, n);
      mass = a.mass() * b->mass() / (a.mass() + b->mass());
    } else {
      const Contact c = wall(a, a.position, ~other, now_);
      n = -c.inward;
      u = a.velocity - c.wall_speed + a.radius * cross(a.spin, n);
    }
    const double approach = dot(u, n);
    const Vec3 slip = u - approach * n;
    const double e = rule_.restitution.at(approach), normal = mass * (1 + e) * approach;
    const double wish = mass * 2 / 7 * (1 - rule_.tangential_restitution) * norm(slip);
    const double share = wish > 0 ? std::min(1.0, rule_.friction * normal / wish) : 0.0;
    const Vec3 impulse =
        -normal * n - share * mass * 2 / 7 * (1 - rule_.tangential_restitution) * slip;
    a.velocity += impulse / a.mass();
    a.spin += a.radius / a.inertia() * cross(n, impulse);
    if (b != nullptr) {
      b->velocity -= impulse / b->mass();
      b->spin += b->radius / b->inertia() * cross(n, impulse);
    }
    return approach;
  }
  Vec3 toward(const scene::Ball& a, const scene::Ball& b) const {
    const Vec3 r = in_box(b.position - a.position);
    return r / norm(r);
  }
  /// The periodic image in the box about the origin, if the shape is periodic.
  Vec3 in_box(const Vec3& r) const {
    const Vec3 p =
        std::visit([](const auto& s) { return geometry::periods_of(s); }, *chamber_.shape);
    if (p.x == geometry::never) return r;
    return r -
           Vec3{p.x * std::rint(r.x / p.x), p.y * std::rint(r.y / p.y), p.z * std::rint(r.z / p.z)};
  }

  scene::Chamber chamber_;
  std::vector<scene::Ball> balls_;
  contact::BounceRule rule_;
  double noise_;
  Random random_;
  double now_ = 0;
  std::vector<Bounce> walls_;  // wall touch that would end each ball's present flight
};

}  // namespace mahlwerk::tests
