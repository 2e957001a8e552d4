// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/event/guard.hpp"
#include "mahlwerk/event/many_balls.hpp"

namespace mahlwerk::event {

void ManyBalls::hit_wall(std::int32_t ball, int face) {
  bring_to_now(ball);
  const Species& s = species(line(ball));
  Turning& turn = turning(ball);
  const double t = motion_time(now_);
  const Passing where = passing(ball);
  const Wall wall = jar_->wall(face, where.position, t, s.radius);
  const Vec3 n = -wall.inward, glide = where.velocity - wall.velocity;
  account_.deepest_overlap = std::max(account_.deepest_overlap, -wall.gap / s.radius);
  const double round = squared(across(where.velocity, n)) * std::max(wall.bend, 0.0);
  const Touching touch(n, s.mass, glide, s.radius * turn.spin, press_ + round);

  const Bounce b = bounce(bounces_.wall(s.kind, face), touch, now_ - turn.last,
                          {turn.stored, sustained_.room(s.mass, press_)});
  const Vec3 impulse = touch.impulse(b.impulse);
  const double before = kinetic(ball, now_);
  kick(ball, impulse, s.radius * n);
  const double work =
      dot(impulse, epoch_.velocity + now_ * gravity_ + drift().velocity + wall.velocity);
  account_.wall_work += work;
  settle_account(touch, b, kinetic(ball, now_) - before, work, before);
  count_contact(turn, slow(touch));
  record(ball, ~face, touch, wall.point, b.impulse.normal, b.loss);
  plan(ball);
}

void ManyBalls::hit_ball(std::int32_t ball, std::int32_t other) {
  bring_to_now(ball);
  bring_to_now(other);
  if (turning(other).name < turning(ball).name) std::swap(ball, other);
  const Line &a = line(ball), &b = line(other);
  const Species &sa = species(a), &sb = species(b);
  Turning &ta = turning(ball), &tb = turning(other);
  const Vec3 apart = nearest_image(b.position - a.position, periods_);
  const double distance = norm(apart), reach = sa.radius + sb.radius;
  const Vec3 n = apart / distance, glide = a.velocity - b.velocity;
  account_.deepest_overlap =
      std::max(account_.deepest_overlap, (reach - distance) / std::min(sa.radius, sb.radius));
  const Touching touch(n, sa.mass * sb.mass / (sa.mass + sb.mass), glide,
                       sa.radius * ta.spin + sb.radius * tb.spin, press_);

  const double since = now_ - std::max(ta.last, tb.last);
  const Bounce bounced = bounce(
      bounces_.balls(sa.kind, sb.kind), touch, since,
      {ta.stored, sustained_.room(sa.mass, press_), tb.stored, sustained_.room(sb.mass, press_)});
  const Vec3 impulse = touch.impulse(bounced.impulse);
  const double before = kinetic(ball, now_) + kinetic(other, now_);
  kick(ball, impulse, sa.radius * n);
  kick(other, -impulse, -sb.radius * n);
  settle_account(touch, bounced, kinetic(ball, now_) + kinetic(other, now_) - before, 0, before);
  count_contact(ta, slow(touch));
  count_contact(tb, slow(touch));
  record(ball, tb.name, touch, passing(ball).position + sa.radius * n, bounced.impulse.normal,
         bounced.loss);
  plan(ball);
  plan(other);
}

/// The time since a ball's last collision was time in contact if it was short, and the bounce as
/// slow as those of a sustained contact are (man.7).
void ManyBalls::count_contact(Turning& ball, bool slow) {
  const double flight = now_ - ball.last;
  if (rules_.lasting == Lasting::tc && slow && flight < 5 * rules_.contact_time)
    account_.contact_time += flight;
  ball.last = now_;
}

/// `since` [s] is the time since one of the two last collided. By the pair's rule, or by that of
/// lasting contacts (man.4).
ManyBalls::Bounce ManyBalls::bounce(const contact::BounceRule& rule, const Touching& touch,
                                    double since, StoredEnergy stored) {
  ++account_.collisions;
  // Two that lost all their normal speed to each other may meet again at none, or less by rounding.
  const double approach = std::max(touch.approach, 1e-200);
  if (rules_.lasting != Lasting::tc) {
    const contact::Impulse j = contact::bounce(rule, touch.mass, approach, touch.slip);
    return {j, contact::loss(j, touch.mass, approach, touch.slip)};
  }
  Bounce b = sustained_.collide(
      rule, {touch.mass, approach, touch.slip, since, touch.press, stored.sum()});
  stored.settle(b);
  if (b.raised) ++account_.tc_collisions;
  account_.withheld += b.withheld;
  if (since < rules_.contact_time) {
    account_.lost_within += b.loss.normal + b.loss.tangential;
    if (approach >= rules_.threshold) ++account_.hits_within;
  }
  return b;
}

/// `arm` [m] from the centre to the contact.
void ManyBalls::kick(std::int32_t ball, const Vec3& impulse, const Vec3& arm) {
  Line& l = line(ball);
  const Species& s = species(l);
  l.velocity += impulse / s.mass;
  ++l.bent;
  turning(ball).spin += cross(arm, impulse) / s.inertia;
}

void ManyBalls::settle_account(const Touching& touch, const Bounce& bounce, double gained,
                               double work, double scale) {
  const contact::Loss& loss = bounce.loss;
  refuse_gain(loss, touch.mass, touch.approach, touch.slip, mill_time() - start_);
  account_.elastic += bounce.kept;
  account_.lost_normal += loss.normal;
  account_.lost_tangential += loss.tangential;
  const double lost = loss.normal + loss.tangential + bounce.kept;
  const double residual =
      std::abs(gained - work + lost) / (scale + std::abs(work) + std::abs(lost) + 1e-300);
  if (!(residual <= account_.worst_collision)) account_.worst_collision = residual;
}

void ManyBalls::record(std::int32_t ball, std::int32_t other, const Touching& touch,
                       const Vec3& point, double impulse, const contact::Loss& loss) {
  const double t = mill_time();
  finished_.push_back({.time = t - start_,
                       .duration = 0,
                       .ball = turning(ball).name,
                       .other = other,
                       .where = jar_->own(point, t),
                       .normal = jar_->own(touch.normal, t),
                       .mass = touch.mass,
                       .approach = touch.approach,
                       .slip = touch.slip,
                       .glide = norm(touch.gliding),
                       .impulse = impulse,
                       .lost_normal = loss.normal,
                       .lost_tangential = loss.tangential});
}

double ManyBalls::kinetic(std::int32_t ball, double t) const {
  const auto i = static_cast<std::size_t>(ball);
  const Species& s = species(lines_[i]);
  return 0.5 * s.mass * squared(lab_velocity(lines_[i], t)) +
         0.5 * s.inertia * squared(turnings_[i].spin);
}

scene::Account ManyBalls::account() const {
  scene::Account a = account_;
  const double t = reached_ + start_ - before_;
  a.time = reached_;
  a.kinetic = a.potential = 0;
  for (std::int32_t ball = 0; ball < std::ssize(lines_); ++ball) {
    const Line& l = lines_[static_cast<std::size_t>(ball)];
    a.kinetic += kinetic(ball, t);
    const Vec3 place = l.at(t) + epoch_.centre + t * (epoch_.velocity + 0.5 * t * gravity_);
    a.potential -= species(l).mass * dot(gravity_, place);
  }
  return a;
}

std::vector<scene::Ball> ManyBalls::balls() const {
  const double t = reached_ + start_ - before_;
  const Drift d = drift_at(t);
  std::vector<scene::Ball> list(lines_.size());
  for (std::size_t i = 0; i < lines_.size(); ++i) {
    const Line& l = lines_[i];
    const Species& s = species(l);
    list[static_cast<std::size_t>(turnings_[i].name)] = {
        s.radius, s.density, l.at(t) - d.place, l.velocity - d.velocity, turnings_[i].spin, s.kind};
  }
  return list;
}

}  // namespace mahlwerk::event
