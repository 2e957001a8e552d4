// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "mahlwerk/contact/contact_model.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/geometry/shapes.hpp"
#include "mahlwerk/kinematics/motions.hpp"
#include "mahlwerk/soft/engine.hpp"
#include "one_ball.hpp"

// Jars, balls and collisions shared by the tests of the soft engine.
namespace mahlwerk::tests {

constexpr contact::ElasticConstants rigid{INFINITY, 0};

inline contact::Pair pair_of(const contact::ElasticConstants& a, const contact::ElasticConstants& b,
                             double e, double mu = 0) {
  contact::Pair pair;
  pair.modulus = contact::effective_modulus(a, b);
  pair.shear_modulus = contact::effective_shear_modulus(a, b);
  pair.restitution = e;
  pair.friction = mu;
  return pair;
}

inline scene::Chamber still_box(double side, const Vec3& pull = {}) {
  return {geometry::Box{side, side, side}, kinematics::Still{}, {}, pull};
}

inline contact::ContactModel of_law(const contact::AnyLaw& law,
                                    contact::Rolling rolling = contact::Rolling::none) {
  return {.law = law, .rolling = rolling};
}

/// A soft engine in which all contacts have the parameters `pair`.
inline std::unique_ptr<scene::Engine> soft_engine(const scene::Chamber& chamber,
                                                  const std::vector<scene::Ball>& balls,
                                                  const contact::ContactModel& model,
                                                  const contact::Pair& pair, double step,
                                                  bool hop = false, double start = 0) {
  const int faces = geometry::faces(*chamber.shape);
  return soft::make_engine(chamber, balls, {model, step, hop}, contact::PairTable(1, faces, pair),
                           start);
}

/// Effective radius R* and mass m* of a ball at a flat wall.
inline contact::EffectivePair touching(const contact::Pair& pair, const scene::Ball& b) {
  return {pair, b.radius, b.mass()};
}
/// The same for one ball at a flat wall, or for two balls.
inline contact::EffectivePair touching(const contact::Pair& pair,
                                       const std::vector<scene::Ball>& both) {
  const scene::Ball &a = both.front(), &b = both.back();
  if (both.size() == 1) return touching(pair, a);
  return {pair, a.radius * b.radius / (a.radius + b.radius),
          a.mass() * b.mass() / (a.mass() + b.mass())};
}

/// Duration of a collision by the formula of the law, or of its fastest part [s].
inline double contact_time(const contact::ContactModel& model, const contact::EffectivePair& t,
                           double speed) {
  return std::visit([&](const auto& l) { return l.shortest_time(t, speed); }, *model.law);
}

/// A collision without gravity, of a ball with the floor (normal -z) or of two balls (normal +x).
struct Impact {
  std::vector<scene::Ball> before, after;
  scene::Collision record;
  scene::EnergyBalance energy_balance;
  double duration = 0;     ///< [s] from touch to separation, to a fraction of a step
  double deepest = 0;      ///< [m]
  double restitution = 0;  ///< measured
  double step = 0;         ///< [s]
};

/// Simulates the collision in steps of `share` of the contact time. The touch occurs a fraction
/// `phase` of a step after the start of a step.
inline Impact impact(std::vector<scene::Ball> balls, const contact::Pair& pair,
                     const contact::ContactModel& model, double share, double phase = 0.37) {
  const bool floor = balls.size() == 1;
  const Vec3 n = floor ? Vec3{0, 0, -1} : Vec3{1, 0, 0};
  const double side = 40 * balls[0].radius + (floor ? 0 : 40 * balls[1].radius);
  const auto closing = [&](const std::vector<scene::Ball>& b) {
    return dot(b[0].velocity - (floor ? Vec3{} : b[1].velocity), n);
  };
  const auto gap = [&](const std::vector<scene::Ball>& b) {
    if (floor) return b[0].position.z + 0.5 * side - b[0].radius;
    return norm(b[1].position - b[0].position) - b[0].radius - b[1].radius;
  };
  const double speed = closing(balls);
  Impact found;
  found.step = share * contact_time(model, touching(pair, balls), speed);
  const double wanted = (3 + phase) * found.step * speed;
  if (floor)
    balls[0].position = {0, 0, -0.5 * side + balls[0].radius + wanted};
  else
    balls[1].position = (balls[0].radius + balls[1].radius + wanted) * n;
  const double apart = gap(balls);
  const auto engine = soft_engine(still_box(side), balls, model, pair, found.step);
  Recorder recorder;
  double time = 0;
  for (int i = 0; recorder.all.empty() && i < 1000; ++i) {
    time += 50 * found.step;
    engine->advance(time, recorder);
  }
  found.before = balls;
  found.after = engine->balls();
  found.energy_balance = engine->energy_balance();
  if (!recorder.all.empty()) found.record = recorder.all.front();
  found.restitution = -closing(found.after) / speed;
  found.deepest =
      found.energy_balance.deepest_overlap * std::min(balls.front().radius, balls.back().radius);
  found.duration =
      found.energy_balance.time - apart / speed + gap(found.after) / closing(found.after);
  return found;
}

}  // namespace mahlwerk::tests
