// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <utility>
#include <vector>

#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "soft.hpp"

namespace mahlwerk::tests {

/// A wall near a ball, in the coordinates of a frame.
struct PlainWall {
  double distance = 0;          ///< [m] of the ball's centre
  Vec3 inward, velocity, spin;  ///< velocity of its material at the wall contact point
};

/// A frame of reference: walls, which may move, a field that accelerates balls, and the angular
/// velocity of the frame itself.
struct PlainWorld {
  std::function<std::vector<PlainWall>(const Vec3& place, double t)> walls;
  std::function<Vec3(const Vec3& place, const Vec3& velocity, double t)> field;
  Vec3 turning;  ///< [rad/s], constant
};

/// Reference implementation of the soft engine, as simple as possible and kept permanently: scalar
/// arithmetic, all pairs at every step, Hertz and Mindlin written out, velocity Verlet with
/// predicted velocities for the dampers. No contact packets, no neighbour list, no free-flight
/// skip. Balls must not touch at the start.
class PlainSoft {
 public:
  struct Touch {
    double time = 0, approach = 0;
    int ball = 0, other = 0;  ///< other < 0: face ~other
  };

  PlainSoft(PlainWorld world, std::vector<scene::Ball> balls, const contact::Pair& pair,
            double step, contact::Rolling rolling = contact::Rolling::none)
      : world_(std::move(world)),
        balls_(std::move(balls)),
        pair_(pair),
        dt_(step),
        rolling_(rolling) {
    for (const scene::Ball& b : balls_)
      pushed_.push_back({world_.field(b.position, b.velocity, 0), turned(b.spin)});
  }

  const std::vector<scene::Ball>& balls() const { return balls_; }
  const std::vector<Touch>& touches() const { return touches_; }
  double time() const { return static_cast<double>(steps_) * dt_; }

  void advance(int steps) {
    for (int i = 0; i < steps; ++i) step();
  }

 private:
  struct Pushed {
    Vec3 acceleration, spin_up;
  };
  struct ContactGeometry {
    Vec3 n, u, spin;  ///< normal from first to second; relative surface velocity; relative spin
    Vec3 spins[2];    ///< of both bodies
    double radii[2] = {0, 0};  ///< of both bodies; 0 for a wall
    double overlap = 0, lever = 0, other_lever = 0, radius = 0, mass = 0, inertia = 0;
  };

  /// In a rotating frame, a spin that is constant in the laboratory rotates backwards.
  Vec3 turned(const Vec3& spin) const { return -cross(world_.turning, spin); }

  void step() {
    const std::size_t n = balls_.size();
    std::vector<scene::Ball> seen = balls_;
    for (std::size_t i = 0; i < n; ++i) {
      scene::Ball& b = balls_[i];
      seen[i].velocity = b.velocity + dt_ * pushed_[i].acceleration;
      seen[i].spin = b.spin + dt_ * pushed_[i].spin_up;
      b.velocity += 0.5 * dt_ * pushed_[i].acceleration;
      b.spin += 0.5 * dt_ * pushed_[i].spin_up;
      b.position += dt_ * b.velocity;
      seen[i].position = b.position;
    }
    ++steps_;
    for (std::size_t i = 0; i < n; ++i)
      pushed_[i] = {world_.field(seen[i].position, seen[i].velocity, time()), turned(seen[i].spin)};
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = i + 1; j < n; ++j) meet(seen, i, j);
      const std::vector<PlainWall> walls = world_.walls(seen[i].position, time());
      for (std::size_t face = 0; face < walls.size(); ++face) meet(seen, i, walls[face], face);
    }
    for (std::size_t i = 0; i < n; ++i) {
      balls_[i].velocity += 0.5 * dt_ * pushed_[i].acceleration;
      balls_[i].spin += 0.5 * dt_ * pushed_[i].spin_up;
    }
  }

  void meet(const std::vector<scene::Ball>& seen, std::size_t i, std::size_t j) {
    const scene::Ball &a = seen[i], &b = seen[j];
    const Vec3 apart = b.position - a.position;
    ContactGeometry m;
    m.n = apart / norm(apart);
    m.overlap = a.radius + b.radius - norm(apart);
    m.lever = a.radius - 0.5 * m.overlap;
    m.other_lever = b.radius - 0.5 * m.overlap;
    m.u = a.velocity - b.velocity + cross(m.lever * a.spin + m.other_lever * b.spin, m.n);
    m.spin = a.spin - b.spin;
    m.spins[0] = a.spin, m.spins[1] = b.spin;
    m.radii[0] = a.radius, m.radii[1] = b.radius;
    m.radius = a.radius * b.radius / (a.radius + b.radius);
    m.mass = a.mass() * b.mass() / (a.mass() + b.mass());
    m.inertia = a.inertia() * b.inertia() / (a.inertia() + b.inertia());
    const auto [force, torque] = push(m, static_cast<int>(i), static_cast<int>(j));
    give(i, force, m.lever * cross(m.n, force) + torque[0]);
    give(j, -force, m.other_lever * cross(m.n, force) + torque[1]);
  }
  void meet(const std::vector<scene::Ball>& seen, std::size_t i, const PlainWall& wall,
            std::size_t face) {
    const scene::Ball& a = seen[i];
    ContactGeometry m;
    m.n = -wall.inward;
    m.overlap = a.radius - wall.distance;
    m.lever = wall.distance;
    m.u = a.velocity - wall.velocity + cross(m.lever * a.spin, m.n);
    m.spin = a.spin - wall.spin;
    m.spins[0] = a.spin;
    m.radii[0] = a.radius;
    m.radius = a.radius;
    m.mass = a.mass();
    m.inertia = a.inertia();
    const auto [force, torque] = push(m, static_cast<int>(i), ~static_cast<int>(face));
    give(i, force, m.lever * cross(m.n, force) + torque[0]);
  }
  void give(std::size_t i, const Vec3& force, const Vec3& torque) {
    pushed_[i].acceleration += force / balls_[i].mass();
    pushed_[i].spin_up += torque / balls_[i].inertia();
  }

  /// Damped forces of Hertz and Mindlin at an overlap; forces < 0 pull.
  struct Hertz {
    double elastic = 0, damper = 0, stiffness = 0, damping = 0, slope = 0;
    double force() const { return elastic + damper; }
  };
  Hertz hertz(const ContactGeometry& m, double overlap, double rate) const {
    const double a = std::sqrt(m.radius * overlap), ln = std::log(pair_.restitution);
    const double beta = ln / std::sqrt(ln * ln + std::numbers::pi * std::numbers::pi);
    const double along = 2 * pair_.modulus * a, across = 8 * pair_.shear_modulus * a;
    const double damp = -2 * std::sqrt(5.0 / 6) * beta;
    return {4.0 / 3 * pair_.modulus * a * overlap, damp * std::sqrt(along * m.mass) * rate, across,
            damp * std::sqrt(across * m.mass), along};
  }
  /// Weights of the first force of a contact, at the fraction `since` of a step after touch: of the
  /// dampers, and of the elastic force (dem.35).
  static double counted(double since) {
    const double share =
        0.31709151755564424 +
        since * (0.8639717633735045 + since * (0.16417356305177494 - since * 0.028025128008455826));
    return share / std::sqrt(std::sqrt(since));
  }
  static double counted_elastic(double since) {
    const double share =
        0.0254941970299688 +
        since * (0.3113754078497435 +
                 since * (0.5514419661692912 +
                          since * (0.15141145787596966 - since * 0.014244103851504217)));
    return share / (since * std::sqrt(since));
  }

  /// Torques of rolling resistance on both bodies under the load N.
  std::array<Vec3, 2> rolling_torques(const ContactGeometry& m, double load) const {
    std::array<Vec3, 2> torques{};
    const double stopping = 0.0625 * m.inertia / dt_;
    const double mu = pair_.rolling_friction;
    if (rolling_ == contact::Rolling::cdt) {
      const Vec3 rolling = m.spin - dot(m.spin, m.n) * m.n;
      if (norm(rolling) > 0)
        torques[0] = -std::min(mu * m.radius * load / norm(rolling), stopping) * rolling;
      torques[1] = -torques[0];
    }
    if (rolling_ == contact::Rolling::own_spin)
      for (int k = 0; k < 2; ++k)
        if (norm(m.spins[k]) > 0)
          torques[k] = -std::min(mu * m.radii[k] * load / norm(m.spins[k]), stopping) * m.spins[k];
    return torques;
  }

  /// Force on the first body, and rolling torques on both.
  std::pair<Vec3, std::array<Vec3, 2>> push(const ContactGeometry& m, int i, int j) {
    const bool touching = m.overlap > 0;
    if (!touching && !springs_.contains({i, j})) return {};
    const double rate = dot(m.u, m.n), way = std::abs(rate) * dt_;
    const Vec3 slip = m.u - rate * m.n;
    const auto [at, fresh] = springs_.try_emplace({i, j});
    double counts = 1, elastic = 1, stiff_counts = 1, overlap = m.overlap;
    bool weighed = false;
    const auto weigh = [&](double since, double already) {
      weighed = true;
      counts = counted(since) - already;
      elastic = counted_elastic(since) - already;
      stiff_counts = already > 0 ? counts : counted_elastic(std::max(since, 0.02));
    };
    if (fresh) {
      touches_.push_back({time(), rate, i, j});
      const double since = std::min(overlap / way, 1.0);
      if (rate > 0 && overlap < 1.5 * way) {
        weigh(since, 0);
        at->second.spring = (since - 0.5) * dt_ * slip;
      }
    }
    // The rate was predicted from the force of the step before (dem.45).
    const auto rated = [&](Hertz f) {
      f.damper *= 1 - dt_ * dt_ / (2 * m.mass) * f.slope;
      return f;
    };
    const bool pulls = touching && rated(hertz(m, overlap, rate)).force() < 0;
    const bool turned = touching && pulls != at->second.pulls;
    at->second.pulls = pulls;
    if (!touching) {
      const double since = std::clamp((overlap + way) / way, 1e-9, 1.0);
      const bool made_up_for = rate < 0 && (overlap + way) / way > -0.5;
      counts = elastic = stiff_counts = 0;
      if (made_up_for) weigh(since, 1);
      overlap = since * way;
    }
    Hertz f = hertz(m, overlap, rate);
    if (!weighed) f = rated(f);
    f.elastic *= elastic, f.damper *= counts, f.stiffness *= stiff_counts, f.damping *= counts;
    // The spring turns with the contact, grows by the mean slip of two steps, and is cut off at
    // Coulomb's limit.
    const Vec3 half = 0.5 * dt_ * slip, last = at->second.spring;
    const Vec3 laid = last - dot(last, m.n) * m.n;
    Vec3 spring = norm(laid) == 0 ? Vec3{} : norm(last) / norm(laid) * laid;
    // Spring and dashpot for the step (dem.37), w the frequency of the spring.
    // The last stiffness of a contact, a correction, may be negative.
    const double mass = 2.0 / 7 * m.mass,
                 half_phase = 0.5 * dt_ * std::sqrt(std::abs(f.stiffness) / mass);
    const double q =
        f.stiffness < 0 ? -std::pow(std::sinh(half_phase), 2) : std::pow(std::sin(half_phase), 2);
    const double p = 1 + 3 * q;
    const double stiff = mass / (dt_ * dt_) * 4 * q * (1 + 2 * q) / p;
    const double damping = mass / dt_ * 4 * q * q / p + f.damping / p;
    if (turned && norm(spring) > 0)  // the limit was 0 about half a step ago
      spring *= std::clamp(-damping * dot(slip, spring) / (stiff * squared(spring)), 0.0, 1.0);
    spring += half;
    Vec3 force = -stiff * spring - damping * slip;
    const double most = pair_.friction * std::abs(f.force());
    if (norm(force) > most) {
      force *= most / norm(force);
      const double length = norm(spring);
      const double held = most + std::max(0.0, -damping * dot(slip, spring) / length);
      if (stiff * length > held) spring *= held / (stiff * length);
    }
    at->second.spring = spring + half;
    const auto torques = touching ? rolling_torques(m, std::abs(f.force())) : std::array<Vec3, 2>{};
    if (!touching) springs_.erase({i, j});
    return {force - f.force() * m.n, torques};
  }

  PlainWorld world_;
  std::vector<scene::Ball> balls_;
  contact::Pair pair_;
  double dt_;
  contact::Rolling rolling_;
  std::vector<Pushed> pushed_;
  struct Spring {
    Vec3 spring;  // half a step ahead
    bool pulls = false;
  };
  std::map<std::pair<int, int>, Spring> springs_;
  std::vector<Touch> touches_;
  long steps_ = 0;
};

/// The laboratory frame: the jar moves and balls fall. Positions are laboratory coordinates.
inline PlainWorld laboratory(const scene::Chamber& chamber) {
  const auto walls = [chamber](const Vec3& place, double t) {
    const auto [frame, turn, spin] = std::visit(
        [t](const auto& m) { return std::tuple(m.frame_motion(t), m.rotation(t), m.spin(t)); },
        *chamber.motion);
    const Rotation q = turn * chamber.mount;
    const Vec3 here = place - frame.centre;
    std::vector<PlainWall> found;
    std::visit(
        [&, &r = frame, &w = spin](const auto& shape) {
          for (int face = 0; face < shape.faces; ++face) {
            const geometry::Gap gap = shape.gap(face, q.apply_inverse(here));
            const Vec3 inward = q * gap.inward;
            const Vec3 foot = here - gap.distance * inward;
            found.push_back({gap.distance, inward, r.velocity + cross(w, foot), w});
          }
        },
        *chamber.shape);
    return found;
  };
  const Vec3 g = chamber.gravity;
  return {walls, [g](const Vec3&, const Vec3&, double) { return g; }, {}};
}

}  // namespace mahlwerk::tests
