// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/contact/twisting_impulse.hpp"
#include "mahlwerk/event/guard.hpp"
#include "mahlwerk/event/many_balls.hpp"

namespace mahlwerk::event {

void ManyBalls::hit_wall(std::int32_t ball, int face) {
  advance_to_now(ball);
  const Species& s = species(trajectory(ball));
  CollisionData& data = collision_data(ball);
  const double t = motion_time(now_);
  const BallState where = ball_state(ball);
  const Wall wall = jar_->wall(face, where.position, t, s.radius);
  const Vec3 n = -wall.inward, relative_velocity = where.velocity - wall.velocity;
  energy_balance_.deepest_overlap = std::max(energy_balance_.deepest_overlap, -wall.gap / s.radius);
  const double centripetal_acceleration =
      squared(tangential_part(where.velocity, n)) * std::max(wall.curvature, 0.0);
  const CollisionKinematics touch(n, s.mass, contact::slip_factor(s.inertia_ratio),
                                  relative_velocity, s.radius * data.spin,
                                  pressing_acceleration_ + centripetal_acceleration);

  const double since = now_ - data.last_collision;
  const contact::BounceRule& rule = bounces_.wall(s.kind, face);
  Bounce b =
      bounce(rule, touch, s.radius, since,
             {data.stored_energy, tc_rule_.storage_capacity(s.mass, pressing_acceleration_)});
  const Vec3 impulse = touch.impulse(b.total_impulse());
  const double before = kinetic(ball, now_);
  apply_impulse(ball, impulse, s.radius * n);
  double work =
      dot(impulse, epoch_.velocity + now_ * gravity_ + jar_offset().velocity + wall.velocity);
  if (twists(b)) {
    const double jar_spin = dot(jar_->spin(t), n), spin = dot(data.spin, n) - jar_spin;
    const contact::Twist twist =
        contact::twist(wall_pair(rules_.twisting, s, face), rule, s.inertia,
                       b.touch_speed(s.mass, touch.approach), b.impulse.normal, spin);
    data.spin -= twist.impulse / s.inertia * n;
    work -= twist.impulse * jar_spin;
    b.twisting_loss = twist.loss;
  }
  energy_balance_.wall_work += work;
  update_energy_balance(touch, b, kinetic(ball, now_) - before, work, before);
  add_contact_time(data, slow(touch));
  record(ball, ~face, touch, wall.point, b, since, wall_pair(rules_.elastic, s, face));
  predict_and_schedule(ball, candidates(ball));
}

[[gnu::flatten]] void ManyBalls::hit_ball(std::int32_t ball, std::int32_t other) {
  advance_to_now(ball);
  advance_to_now(other);
  if (collision_data(other).id < collision_data(ball).id) std::swap(ball, other);
  const auto near_ball = candidates(ball, 0), near_other = candidates(other, 1);
  if (lists_ == nullptr && !fits_cache()) {  // the memory answers during the collision
    prefetch_trajectories(near_ball);
    prefetch_trajectories(near_other);
  }
  const Trajectory &a = trajectory(ball), &b = trajectory(other);
  const Species &sa = species(a), &sb = species(b);
  CollisionData &data_a = collision_data(ball), &data_b = collision_data(other);
  const Vec3 apart = nearest_image(b.position - a.position, periods_);
  const double distance = norm(apart), reach = sa.radius + sb.radius;
  const Vec3 n = apart / distance, relative_velocity = a.velocity - b.velocity;
  energy_balance_.deepest_overlap = std::max(energy_balance_.deepest_overlap,
                                             (reach - distance) / std::min(sa.radius, sb.radius));
  const CollisionKinematics touch(
      n, sa.mass * sb.mass / (sa.mass + sb.mass),
      contact::slip_factor({sa.mass, sa.inertia_ratio}, {sb.mass, sb.inertia_ratio}),
      relative_velocity, sa.radius * data_a.spin + sb.radius * data_b.spin, pressing_acceleration_);

  const double since = now_ - std::max(data_a.last_collision, data_b.last_collision);
  const contact::BounceRule& rule = bounces_.balls(sa.kind, sb.kind);
  Bounce bounced =
      bounce(rule, touch, sa.radius * sb.radius / reach, since,
             {data_a.stored_energy, tc_rule_.storage_capacity(sa.mass, pressing_acceleration_),
              data_b.stored_energy, tc_rule_.storage_capacity(sb.mass, pressing_acceleration_)});
  const Vec3 impulse = touch.impulse(bounced.total_impulse());
  const double before = kinetic(ball, now_) + kinetic(other, now_);
  apply_impulse(ball, impulse, sa.radius * n);
  apply_impulse(other, -impulse, -sb.radius * n);
  if (twists(bounced)) {
    const double spin = dot(data_a.spin - data_b.spin, n);
    const contact::Twist twist = contact::twist(ball_pair(rules_.twisting, sa, sb), rule,
                                                sa.inertia * sb.inertia / (sa.inertia + sb.inertia),
                                                bounced.touch_speed(touch.mass, touch.approach),
                                                bounced.impulse.normal, spin);
    data_a.spin -= twist.impulse / sa.inertia * n;
    data_b.spin += twist.impulse / sb.inertia * n;
    bounced.twisting_loss = twist.loss;
  }
  update_energy_balance(touch, bounced, kinetic(ball, now_) + kinetic(other, now_) - before, 0,
                        before);
  add_contact_time(data_a, slow(touch));
  add_contact_time(data_b, slow(touch));
  record(ball, data_b.id, touch, ball_state(ball).position + sa.radius * n, bounced, since,
         ball_pair(rules_.elastic, sa, sb));
  predict_and_schedule(ball, near_ball);
  predict_and_schedule(other, near_other);
}

/// Adds the time since the ball's last collision to the time in contact if it is short and the
/// bounce is as slow as those of a sustained contact (man.7).
void ManyBalls::add_contact_time(CollisionData& ball, bool slow) {
  const double flight = now_ - ball.last_collision;
  if (rules_.sustained_mode == SustainedContactMode::tc && slow && flight < 5 * rules_.contact_time)
    energy_balance_.contact_time += flight;
  ball.last_collision = now_;
}

/// Collision by the pair's rule, or by the TC rule for sustained contacts (man.4). `since` [s] is
/// the time since the last collision of either body.
ManyBalls::Bounce ManyBalls::bounce(const contact::BounceRule& rule,
                                    const CollisionKinematics& touch, double effective_radius,
                                    double since, StoredEnergy stored) {
  ++energy_balance_.collisions;
  // Bodies without relative normal speed may collide again at zero speed, or less by rounding.
  double approach =
      std::max(rules_.touch_speed(effective_radius, touch.mass, touch.approach), 1e-200);
  if (rules_.sustained_mode != SustainedContactMode::tc) {
    const contact::Impulse j = contact::bounce(rule, touch.mass, approach, touch.slip,
                                               rule.restitution.at(approach), touch.slip_factor);
    Bounce b{j, contact::loss(j, touch.mass, approach, touch.slip, touch.slip_factor)};
    if (rules_.liquid) b.slow_down(touch.mass, touch.approach, approach);
    return b;
  }
  if (rules_.liquid)
    approach = tc_rule_.wet_approach(touch.approach, approach, since, touch.pressing_acceleration);
  Bounce b = tc_rule_.collide(rule, {touch.mass, approach, touch.slip, since,
                                     touch.pressing_acceleration, stored.sum(), touch.slip_factor});
  stored.update(b);
  if (rules_.liquid) b.slow_down(touch.mass, touch.approach, approach);
  if (b.raised) ++energy_balance_.tc_collisions;
  energy_balance_.withheld += b.withheld;
  if (since < rules_.contact_time) energy_balance_.lost_within += b.loss.normal + b.loss.tangential;
  return b;
}

/// Applies `impulse` [N s] at `arm` [m] from the centre, and invalidates predictions for the ball.
void ManyBalls::apply_impulse(std::int32_t ball, const Vec3& impulse, const Vec3& arm) {
  Trajectory& path = trajectory(ball);
  const Species& s = species(path);
  path.velocity += impulse / s.mass;
  ++path.revision;
  collision_data(ball).spin += cross(arm, impulse) / s.inertia;
}

void ManyBalls::update_energy_balance(const CollisionKinematics& touch, const Bounce& bounce,
                                      double gained, double work, double before) {
  const contact::Loss& loss = bounce.loss;
  reject_energy_gain(loss, touch.mass, touch.approach, touch.slip, mill_time() - start_);
  energy_balance_.elastic += bounce.stored_change;
  energy_balance_.lost_normal += loss.normal;
  energy_balance_.lost_tangential += loss.tangential;
  energy_balance_.lost_liquid += bounce.liquid_loss;
  energy_balance_.lost_rolling += bounce.twisting_loss;
  const double lost = loss.normal + loss.tangential + bounce.stored_change + bounce.liquid_loss +
                      bounce.twisting_loss;
  check_balance(energy_balance_, gained, work, lost, before);
}

/// A ball and a face; `moduli` may be none where the record joins no bounces.
contact::EffectivePair ManyBalls::wall_pair(const std::optional<contact::PairTable>& moduli,
                                            const Species& ball, int face) const {
  return {.pair = moduli ? moduli->wall(ball.kind, face) : contact::Pair{},
          .radius = ball.radius,
          .mass = ball.mass};
}

contact::EffectivePair ManyBalls::ball_pair(const std::optional<contact::PairTable>& moduli,
                                            const Species& a, const Species& b) const {
  return {.pair = moduli ? moduli->balls(a.kind, b.kind) : contact::Pair{},
          .radius = a.radius * b.radius / (a.radius + b.radius),
          .mass = a.mass * b.mass / (a.mass + b.mass)};
}

/// The longest joining time [s] of any two bodies, that of bounces as slow as can be.
double ManyBalls::longest_joining_time() const {
  double longest = 0;
  if (!rules_.elastic) return longest;
  for (const Species& a : species_) {
    for (int face = 0; face < jar_->faces(); ++face)
      longest = std::max(longest, joining_time(wall_pair(rules_.elastic, a, face), 0, 0));
    for (const Species& b : species_)
      longest = std::max(longest, joining_time(ball_pair(rules_.elastic, a, b), 0, 0));
  }
  return longest;
}

/// Hands over the record of a bounce, or joins it to that of its contact (man.9). `since` [s] is
/// the time since the last collision of either body.
void ManyBalls::record(std::int32_t ball, std::int32_t other, const CollisionKinematics& touch,
                       const Vec3& point, const Bounce& bounce, double since,
                       const contact::EffectivePair& pair) {
  const double t = mill_time(), time = t - start_;
  const double approach = bounce.touch_speed(touch.mass, touch.approach);
  const double lost_tangential = bounce.loss.tangential + bounce.twisting_loss;
  if (rules_.elastic) {
    contacts_.finish_before(time, finished_);
    if (contacts_.join({time, collision_data(ball).id, other, approach, bounce.impulse.normal,
                        bounce.loss.normal, lost_tangential},
                       pair))
      return;
  }
  if (since < rules_.contact_time && approach >= rules_.threshold &&
      rules_.sustained_mode == SustainedContactMode::tc)
    ++energy_balance_.hits_within;
  const scene::Collision first{.time = time,
                               .duration = 0,
                               .ball = collision_data(ball).id,
                               .other = other,
                               .where = jar_->to_jar_axes(point, t),
                               .normal = jar_->to_jar_axes(touch.normal, t),
                               .mass = touch.mass,
                               .approach = approach,
                               .slip = touch.slip,
                               .glide = norm(touch.tangential_velocity),
                               .impulse = bounce.impulse.normal,
                               .lost_normal = bounce.loss.normal,
                               .lost_tangential = lost_tangential};
  if (rules_.elastic)
    contacts_.begin(first);
  else
    finished_.push_back(first);
}

double ManyBalls::kinetic(std::int32_t ball, double t) const {
  const auto i = static_cast<std::size_t>(ball);
  const Species& s = species(trajectories_[i]);
  return 0.5 * s.mass * squared(lab_velocity(trajectories_[i], t)) +
         0.5 * s.inertia * squared(collision_data_[i].spin);
}

scene::EnergyBalance ManyBalls::energy_balance() const {
  scene::EnergyBalance a = energy_balance_;
  const double t = reached_ + start_ - clock_origin_;
  a.time = reached_;
  a.lost_open = contacts_.lost();
  a.kinetic = a.potential = 0;
  for (std::int32_t ball = 0; ball < std::ssize(trajectories_); ++ball) {
    const Trajectory& path = trajectories_[static_cast<std::size_t>(ball)];
    a.kinetic += kinetic(ball, t);
    const Vec3 position = path.at(t) + epoch_.centre + t * (epoch_.velocity + 0.5 * t * gravity_);
    a.potential -= species(path).mass * dot(gravity_, position);
  }
  return a;
}

std::vector<scene::Ball> ManyBalls::balls() const {
  const double t = reached_ + start_ - clock_origin_;
  const JarOffset d = jar_offset_at(t);
  std::vector<scene::Ball> list(trajectories_.size());
  for (std::size_t i = 0; i < trajectories_.size(); ++i) {
    const Trajectory& path = trajectories_[i];
    const Species& s = species(path);
    list[static_cast<std::size_t>(collision_data_[i].id)] = {s.radius,
                                                             s.density,
                                                             path.at(t) - d.position,
                                                             path.velocity - d.velocity,
                                                             collision_data_[i].spin,
                                                             s.kind,
                                                             s.inertia_ratio};
  }
  return list;
}

}  // namespace mahlwerk::event
