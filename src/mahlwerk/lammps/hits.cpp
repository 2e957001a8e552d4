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

/// Share of a collision after which other bodies have changed its speed: in a drum of 10 000 balls,
/// looks at up to 0.4, 0.2 and 0.1 of it found 18, 9 and 3 % too many hits (lmp.10).
constexpr double soon_share = 0.1;

/// [m/s] Sliding speed at first touch of a contact that slides at `slip` after its normal speed has
/// changed by `change` (lmp.11). The tangential spring transmits less than friction would while the
/// surfaces slide slowly.
double slip_at_touch(double slip, double change, double speed, const Impact& impact) {
  const double sticking = impact.spring_ratio() * slip / speed;
  return slip + std::min(impact.friction(), sticking) * std::max(0.0, change) / sliding_mass;
}

/// Speeds, and the losses of an undisturbed collision: by restitution, and by sliding until the
/// surfaces stick.
void set_speeds(scene::Collision& c, const TouchSpeeds& speeds, const Impact& impact) {
  c.mass = impact.mass();
  c.approach = speeds.approach;
  c.slip = speeds.slip;
  c.glide = speeds.glide;
  const double e = impact.restitution();
  c.impulse = c.mass * c.approach * (1 + e);
  c.lost_normal = 0.5 * c.mass * c.approach * c.approach * (1 - e * e);
  const double left = std::max(
      0.0, c.slip - std::min(impact.friction(), 1e6) * (1 + e) * c.approach / sliding_mass);
  c.lost_tangential = 0.5 * sliding_mass * c.mass * (c.slip * c.slip - left * left);
}

TouchSpeeds touch_speeds(const Impact::Found& hit, double rate, const Vec3& normal,
                         const Vec3& centres, const Vec3& surfaces, const Impact& impact) {
  return {
      hit.speed,
      slip_at_touch(norm(tangential_part(surfaces, normal)), hit.speed - rate, hit.speed, impact),
      norm(tangential_part(centres, normal))};
}

std::uint64_t pair_key(std::int32_t one, std::int32_t other) {
  const auto [low, high] = std::minmax(one, other);
  return static_cast<std::uint64_t>(low) << 32U | static_cast<std::uint64_t>(high);
}

/// Whether a contact lasted so long that the soft engine calls it sustained.
bool is_lasting(double duration, const Impact& impact, double approach) {
  constexpr double ratio = 5, slowest = 1e-3;
  return duration > ratio * impact.duration(std::max(approach, slowest));
}

}  // namespace

int SeenContacts::class_of(double strength) {
  constexpr double least = 1e-6;
  return std::clamp(
      static_cast<int>(2 * math::log(std::max(strength, least) / least) / math::log(2.0)), 0,
      classes - 1);
}

void SeenContacts::add(std::pair<int, int> types, double strength, bool brief,
                       const TouchSpeeds& speeds) {
  if (!(strength > 0)) return;
  std::vector<Class>& all = seen_.try_emplace(types, 2 * classes).first->second;
  Class& into = all[static_cast<std::size_t>(class_of(strength) + (brief ? 0 : classes))];
  // No contact is less compressed than its first touch alone would have made it.
  const TouchSpeeds shares{std::min(1.0, speeds.approach / strength), speeds.slip, speeds.glide};
  constexpr std::size_t most = 512;
  if (into.kept.size() < most)
    into.kept.push_back(shares);
  else
    into.kept[into.next++ % most] = shares;
}

TouchSpeeds SeenContacts::like(std::pair<int, int> types, double strength, bool brief) {
  const auto at = seen_.find(types);
  if (at == seen_.end()) return {strength, 0, 0};
  const int own = class_of(strength);
  for (int away = 0; away < classes; ++away)
    for (const bool kind : {brief, !brief})
      for (const int near : {own - away, own + away}) {
        if (near < 0 || near >= classes) continue;
        Class& from = at->second[static_cast<std::size_t>(near + (kind ? 0 : classes))];
        if (from.kept.empty()) continue;
        const TouchSpeeds& shares = from.kept[from.given++ % from.kept.size()];
        return {shares.approach * strength, shares.slip, shares.glide};
      }
  return {strength, 0, 0};
}

Hits::Hits(const cases::Case& mill_case, const scene::Chamber& chamber,
           std::vector<scene::Ball> balls, double time_step)
    : mill_case_(&mill_case),
      pairs_(cases::pair_table(mill_case)),
      jar_(chamber),
      balls_(std::move(balls)),
      types_(types_of(balls_)),
      time_step_(time_step) {}

double Hits::soon(double duration) const {
  return std::max(2 * time_step_, soon_share * duration);
}

std::pair<int, int> Hits::types_of_pair(std::int32_t one, std::int32_t other) const {
  return std::minmax(types_[static_cast<std::size_t>(one)],
                     types_[static_cast<std::size_t>(other)]);
}

const Impact& Hits::impact_of_balls(std::int32_t one, std::int32_t other) {
  const std::pair<int, int> key = types_of_pair(one, other);
  if (const auto at = between_.find(key); at != between_.end()) return at->second;
  const scene::Ball &a = balls_[static_cast<std::size_t>(one)],
                    &b = balls_[static_cast<std::size_t>(other)];
  const contact::EffectivePair pair = pair_of(pairs_.balls(a.kind, b.kind), a, b);
  return between_.try_emplace(key, *mill_case_->contact.model.law, pair).first->second;
}

const Impact& Hits::impact_at_jar(std::int32_t ball, int face, double curvature) {
  const std::pair<int, int> key{types_[static_cast<std::size_t>(ball)], face};
  if (const auto at = at_jar_.find(key); at != at_jar_.end()) return at->second;
  const scene::Ball& a = balls_[static_cast<std::size_t>(ball)];
  const contact::EffectivePair pair{pairs_.wall(a.kind, face),
                                    a.radius / (1 - curvature * a.radius), a.mass()};
  return at_jar_.try_emplace(key, *mill_case_->contact.model.law, pair).first->second;
}

std::optional<TouchSpeeds> Hits::seen(const BallContact& contact, double soon) {
  const auto at = looked_at_.find(pair_key(contact.one, contact.other));
  if (at == looked_at_.end()) return std::nullopt;
  std::optional<TouchSpeeds> found;
  for (const Seen& look : at->second)
    if (!found && look.step >= contact.began && time_of(look.step - contact.began) <= soon)
      found = look.speeds;
  std::erase_if(at->second, [&](const Seen& look) { return look.step <= contact.ended; });
  if (at->second.empty()) looked_at_.erase(at);
  return found;
}

scene::Collision Hits::between_balls(const BallContact& contact) {
  const scene::Ball &a = balls_[static_cast<std::size_t>(contact.one)],
                    &b = balls_[static_cast<std::size_t>(contact.other)];
  const Impact& impact = impact_of_balls(contact.one, contact.other);
  const double overlap = std::max(0.0, a.radius + b.radius - contact.distance);
  deepest_ = std::max(deepest_, overlap / std::min(a.radius, b.radius));
  const double strength = impact.speed_of_largest(overlap);
  const double duration = time_of(contact.ended - contact.began);
  const double undisturbed = strength > 0 ? impact.duration(strength) : 0;
  constexpr double longer = 1.5;
  const bool brief = duration < longer * undisturbed;
  const std::pair<int, int> types = types_of_pair(contact.one, contact.other);
  TouchSpeeds speeds;
  if (const auto own = seen(contact, soon(undisturbed))) {
    speeds = *own;
    seen_.add(types, strength, brief, speeds);
  } else {
    speeds = seen_.like(types, strength, brief);
  }
  lasting_ += is_lasting(duration, impact, speeds.approach) ? 1 : 0;
  scene::Collision c{.time = time_of(contact.began),
                     .duration = duration,
                     .ball = contact.one,
                     .other = contact.other,
                     .where = jar_.to_jar_axes(contact.middle, time_of(contact.ended)),
                     .normal = {}};
  set_speeds(c, speeds, impact);
  return c;
}

scene::Collision Hits::begin_at_jar(std::int32_t ball, const scene::Ball& now,
                                    const scene::Wall& wall, int face, double time) {
  const Vec3 relative = now.velocity - wall.velocity;
  const double rate = -dot(relative, wall.inward);
  const Impact& impact = impact_at_jar(ball, face, wall.curvature);
  const Impact::Found hit = impact.found(-wall.gap, rate);
  const Vec3 surface = relative + cross(now.spin, -now.radius * wall.inward);
  const TouchSpeeds speeds = touch_speeds(hit, rate, wall.inward, relative, surface, impact);
  scene::Collision c{.time = time - hit.since,
                     .ball = ball,
                     .other = ~face,
                     .where = jar_.to_jar_axes(wall.point, time),
                     .normal = jar_.to_jar_axes(-wall.inward, time)};
  set_speeds(c, speeds, impact);
  return c;
}

void Hits::at_jar(std::int32_t ball, const scene::Ball& now, std::int64_t step,
                  std::vector<scene::Collision>& found) {
  const double time = time_of(step);
  for (int face = 0; face < jar_.faces(); ++face) {
    const scene::Wall wall = jar_.wall(face, now.position, time, now.radius);
    const std::int64_t key = static_cast<std::int64_t>(ball) * jar_.faces() + face;
    const auto touching = touching_.find(key);
    if (wall.gap < 0) deepest_ = std::max(deepest_, -wall.gap / now.radius);
    if (wall.gap < 0 && touching == touching_.end()) {
      touching_.emplace(key, begin_at_jar(ball, now, wall, face, time));
    } else if (!(wall.gap < 0) && touching != touching_.end()) {
      scene::Collision& c = touching->second;
      c.duration = time - c.time;
      lasting_ += is_lasting(c.duration, impact_at_jar(ball, face, wall.curvature), c.approach);
      found.push_back(c);
      touching_.erase(touching);
    }
  }
}

bool Hits::look_at_pair(const scene::Ball& a, const scene::Ball& b, std::int32_t one,
                        std::int32_t other, std::int64_t step) {
  const Vec3 between = b.position - a.position;
  const double reach = a.radius + b.radius;
  if (squared(between) >= reach * reach) return false;
  const double distance = norm(between);
  const Vec3 normal = between / distance, relative = a.velocity - b.velocity;
  const double rate = dot(relative, normal);
  const Impact& impact = impact_of_balls(one, other);
  const Impact::Found hit = impact.found(reach - distance, rate);
  if (hit.since > soon(hit.lasts)) return true;
  const Vec3 surface =
      relative + cross(a.spin, a.radius * normal) + cross(b.spin, b.radius * normal);
  looked_at_[pair_key(one, other)].push_back(
      {step, touch_speeds(hit, rate, normal, relative, surface, impact)});
  return true;
}

bool Hits::touches_jar(std::int32_t number, const scene::Ball& ball, double time) {
  bool touches = false;
  for (int face = 0; face < jar_.faces(); ++face) {
    const double gap = jar_.wall(face, ball.position, time, ball.radius).gap;
    touches = touches || gap < 0;
    if (gap < -ball.radius) outside_ = number;
  }
  return touches;
}

/// A grid for each class of size, so that each ball looks for those of its class and of larger
/// ones.
std::int64_t Hits::look(const std::vector<scene::Ball>& balls, std::int64_t step) {
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
  std::vector<bool> in_contact(balls.size(), false);
  for (auto large = by_size.begin(); large != by_size.end(); ++large) {
    const double radius =
        at(std::ranges::max(large->second, {}, [&](int i) { return at(i).radius; })).radius;
    cases::Grid grid(domain, 2 * radius, large->second.size());
    for (const int i : large->second) grid.add(i, at(i).position);
    for (auto small = by_size.begin(); small != std::next(large); ++small)
      for (const int i : small->second)
        grid.for_each_near(at(i).position, [&](int j) {
          if ((small != large || j > i) && look_at_pair(at(i), at(j), i, j, step))
            in_contact[static_cast<std::size_t>(i)] = in_contact[static_cast<std::size_t>(j)] =
                true;
          return true;
        });
  }
  std::int64_t count = 0;
  for (std::size_t i = 0; i < balls.size(); ++i)
    if (touches_jar(static_cast<std::int32_t>(i), balls[i], time_of(step)) || in_contact[i])
      ++count;
  return count;
}

}  // namespace mahlwerk::lammps
