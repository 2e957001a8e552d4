// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/lammps/hits.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/setup/grid.hpp"
#include "mahlwerk/contact/laws.hpp"
#include "mahlwerk/lammps/deck.hpp"

namespace mahlwerk::lammps {
namespace {

/// Effective over true mass of two solid spheres that slide on each other.
constexpr double sliding_mass = 2.0 / 7.0;

/// [m/s] Sliding speed at first touch of a contact that slides at `slip` after its normal speed has
/// changed by `change` (lmp.10). Surfaces that hardly slide have stuck: their speed before is lost.
double slip_at_touch(double slip, double change, double speed, double friction) {
  constexpr double stuck = 0.05;
  if (slip < stuck * speed || !std::isfinite(friction)) return slip;
  return slip + friction * change / sliding_mass;
}

/// Losses of an undisturbed collision: by restitution, and by sliding until the surfaces stick
/// (lmp.11).
void set_losses(scene::Collision& c, const Impact& impact) {
  const double e = impact.restitution();
  c.impulse = c.mass * c.approach * (1 + e);
  c.lost_normal = 0.5 * c.mass * c.approach * c.approach * (1 - e * e);
  const double left =
      std::max(0.0, c.slip - std::min(impact.friction(), 1e6) * (1 + e) * c.approach / sliding_mass);
  c.lost_tangential = 0.5 * sliding_mass * c.mass * (c.slip * c.slip - left * left);
}

}  // namespace

Hits::Hits(const cases::Case& mill_case, const scene::Chamber& chamber,
           std::vector<scene::Ball> balls, double slowest)
    : mill_case_(&mill_case),
      pairs_(cases::pair_table(mill_case)),
      jar_(chamber),
      balls_(std::move(balls)),
      types_(types_of(balls_)),
      slowest_(slowest) {}

const Impact& Hits::impact_of_balls(int one, int other) {
  const std::pair<int, int> key = std::minmax(types_[static_cast<std::size_t>(one)],
                               types_[static_cast<std::size_t>(other)]);
  if (const auto at = between_.find(key); at != between_.end()) return at->second;
  const scene::Ball &a = balls_[static_cast<std::size_t>(one)],
                    &b = balls_[static_cast<std::size_t>(other)];
  const contact::EffectivePair pair{pairs_.balls(a.kind, b.kind),
                                    a.radius * b.radius / (a.radius + b.radius),
                                    a.mass() * b.mass() / (a.mass() + b.mass())};
  return between_.try_emplace(key, *mill_case_->contact.model.law, pair).first->second;
}

const Impact& Hits::impact_at_jar(int ball, int face, double curvature) {
  const std::pair key{types_[static_cast<std::size_t>(ball)], face};
  if (const auto at = at_jar_.find(key); at != at_jar_.end()) return at->second;
  const scene::Ball& a = balls_[static_cast<std::size_t>(ball)];
  const contact::EffectivePair pair{pairs_.wall(a.kind, face),
                                    a.radius / (1 - curvature * a.radius), a.mass()};
  return at_jar_.try_emplace(key, *mill_case_->contact.model.law, pair).first->second;
}

int Hits::class_of(double speed) const {
  return std::clamp(static_cast<int>(2 * math::log(speed / slowest_) / math::log(2.0)), 0,
                    classes - 1);
}

Hits::SlidingByClass& Hits::sliding_of(int one, int other) {
  return sliding_[std::minmax(types_[static_cast<std::size_t>(one)],
                              types_[static_cast<std::size_t>(other)])];
}

/// From a contact of the same class of speed, in turn; else from the nearest class that has one.
Hits::Sliding Hits::sliding_at(SlidingByClass& by_class, double speed) const {
  const int own = class_of(speed);
  for (int away = 0; away < classes; ++away)
    for (const int at : {own - away, own + away}) {
      if (at < 0 || at >= classes) continue;
      SlidingClass& from = by_class[static_cast<std::size_t>(at)];
      if (!from.kept.empty()) return from.kept[from.given++ % from.kept.size()];
    }
  return {};
}

scene::Collision Hits::between_balls(const BallContact& contact) {
  const scene::Ball &a = balls_[static_cast<std::size_t>(contact.one)],
                    &b = balls_[static_cast<std::size_t>(contact.other)];
  const Impact& impact = impact_of_balls(contact.one, contact.other);
  const double overlap = a.radius + b.radius - contact.distance;
  deepest_ = std::max(deepest_, overlap / std::min(a.radius, b.radius));
  scene::Collision c{.time = contact.began,
                     .duration = contact.ended - contact.began,
                     .ball = contact.one,
                     .other = contact.other,
                     .where = jar_.to_jar_axes(contact.middle, contact.ended),
                     .normal = {},
                     .mass = impact.mass(),
                     .approach = impact.speed_of_largest(overlap)};
  const Sliding sliding = sliding_at(sliding_of(contact.one, contact.other), c.approach);
  c.slip = sliding.slip;
  c.glide = sliding.glide;
  set_losses(c, impact);
  return c;
}

void Hits::sample_at_jar(std::int32_t ball, const scene::Ball& now, double time,
                         std::vector<scene::Collision>& found) {
  for (int face = 0; face < jar_.faces(); ++face) {
    const scene::Wall wall = jar_.wall(face, now.position, time, now.radius);
    if (!(wall.gap < 0)) continue;
    const Vec3 relative = now.velocity - wall.velocity;
    const double rate = -dot(relative, wall.inward);
    const Impact& impact = impact_at_jar(ball, face, wall.curvature);
    const Impact::Found hit = impact.found(-wall.gap, rate);
    deepest_ = std::max(deepest_, -wall.gap / now.radius);
    if (hit.speed < slowest_) continue;
    const double began = time - hit.since;
    double& end = touching_[static_cast<std::int64_t>(ball) * jar_.faces() + face];
    constexpr double tolerance = 0.25;  // of a collision, for its course that others disturb
    const bool known = began < end - tolerance * hit.lasts;
    end = began + hit.lasts;
    if (known) continue;
    const Vec3 surface = relative + cross(now.spin, -now.radius * wall.inward);
    scene::Collision c{.time = began,
                       .duration = hit.lasts,
                       .ball = ball,
                       .other = ~face,
                       .where = jar_.to_jar_axes(wall.point, time),
                       .normal = jar_.to_jar_axes(-wall.inward, time),
                       .mass = impact.mass(),
                       .approach = hit.speed};
    c.slip = slip_at_touch(norm(tangential_part(surface, wall.inward)), hit.speed - rate, hit.speed,
                           impact.friction());
    c.glide = norm(tangential_part(relative, wall.inward));
    set_losses(c, impact);
    found.push_back(c);
  }
}

void Hits::sample_pair(const scene::Ball& a, const scene::Ball& b, int one, int other) {
  const Vec3 between = b.position - a.position;
  const double distance = norm(between), overlap = a.radius + b.radius - distance;
  if (!(overlap > 0)) return;
  const Vec3 normal = between / distance, relative = a.velocity - b.velocity;
  const double rate = dot(relative, normal);
  const Impact& impact = impact_of_balls(one, other);
  const Impact::Found hit = impact.found(overlap, rate);
  if (hit.speed < slowest_) return;
  const Vec3 surface = relative + cross(a.spin, a.radius * normal) + cross(b.spin, b.radius * normal);
  SlidingClass& into = sliding_of(one, other)[static_cast<std::size_t>(class_of(hit.speed))];
  const Sliding sliding{slip_at_touch(norm(tangential_part(surface, normal)), hit.speed - rate,
                                      hit.speed, impact.friction()),
                        norm(tangential_part(relative, normal))};
  constexpr std::size_t most = 256;
  if (into.kept.size() < most)
    into.kept.push_back(sliding);
  else
    into.kept[into.next++ % most] = sliding;
}

/// A grid for each class of size, so that each ball looks for those of its class and of larger
/// ones.
void Hits::sample_between_balls(const std::vector<scene::Ball>& balls) {
  const double least = std::ranges::min(balls, {}, &scene::Ball::radius).radius;
  std::map<int, std::vector<int>> by_size;  // factors of two
  Vec3 half;
  for (std::size_t i = 0; i < balls.size(); ++i) {
    const Vec3 reach = componentwise_abs(balls[i].position);
    half = {std::max(half.x, reach.x), std::max(half.y, reach.y), std::max(half.z, reach.z)};
    by_size[static_cast<int>(math::log(balls[i].radius / least) / math::log(2.0) + 1e-9)].push_back(
        static_cast<int>(i));
  }
  const cases::Domain domain{half, {INFINITY, INFINITY, INFINITY}};
  const auto at = [&](int i) -> const scene::Ball& { return balls[static_cast<std::size_t>(i)]; };
  for (auto large = by_size.begin(); large != by_size.end(); ++large) {
    const double radius =
        at(std::ranges::max(large->second, {}, [&](int i) { return at(i).radius; })).radius;
    cases::Grid grid(domain, 2 * radius, large->second.size());
    for (const int i : large->second) grid.add(i, at(i).position);
    for (auto small = by_size.begin(); small != std::next(large); ++small)
      for (const int i : small->second)
        grid.for_each_near(at(i).position, [&](int j) {
          if (small != large || j > i) sample_pair(at(i), at(j), i, j);
          return true;
        });
  }
}

}  // namespace mahlwerk::lammps
