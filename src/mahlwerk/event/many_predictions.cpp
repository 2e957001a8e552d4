// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <tuple>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/index.hpp"
#include "mahlwerk/event/many_balls.hpp"
#include "mahlwerk/kinematics/strongest_field.hpp"

namespace mahlwerk::event {
namespace {

TouchTolerance tolerance(const MovingWall& jar, double radius) {
  const auto& bounds = jar.motion_bounds();
  const double scale =
      jar.reach() + jar.offset() +
      (bounds.jerk > 0 ? bounds.speed * bounds.speed / (norm(bounds.acceleration) + 1e-300) : 0.0);
  return {radius, std::max(1e-12 * radius, 64 * 0x1p-52 * scale)};
}

/// Radius of the spheres of neighbour lists [m], or 0 if the cells serve better. Lists halve the
/// candidates of a prediction but cost a renewal whenever a ball leaves its sphere, so they suit a
/// packing in which a ball seldom gets that far. Balls must fly straight and have a periodic box
/// of at least five spheres' reach, and lists of large balls among small ones would grow long.
double neighbour_skin(const MovingWall& jar, double max_acceleration,
                      const std::vector<double>& radii, double ball_volume) {
  constexpr double least_packing = 0.4, share = 0.25;  // measured; of the largest diameter
  const Vec3 size = jar.periods();
  if (!(size.x < never) || max_acceleration > 0) return 0;
  const auto [smallest, largest] = std::ranges::minmax(radii);
  if (2 * smallest <= largest || ball_volume < least_packing * size.x * size.y * size.z) return 0;
  const double skin = share * 2 * largest, reach = 2 * largest + 2 * skin;
  return std::min({size.x, size.y, size.z}) < 5.01 * reach ? 0 : skin;
}

/// Grid over the box that contains the centres of all balls. With neighbour lists it sorts their
/// spheres, of the radius `skin` [m], else the balls themselves.
std::unique_ptr<HierarchicalGrid> make_grid(const MovingWall& jar, double max_acceleration,
                                            const std::vector<double>& radii, std::size_t balls,
                                            double skin) {
  const bool periodic = jar.periods().x < never;
  const Vec3 size = periodic ? jar.periods() : 2 * jar.reach() * Vec3{1, 1, 1};
  // Safe times from a bound on the acceleration end before the ball reaches the border, so a ball
  // near it would be tested in ever shorter steps. With slack, one of the tests finds it beyond the
  // border.
  const double slack = max_acceleration > 0 ? 0.02 : 1e-7;
  std::vector<double> diameters;
  for (const double r : radii) diameters.push_back(2 * r);
  const double widest = *std::ranges::max_element(diameters);
  if (periodic && std::min({size.x, size.y, size.z}) <= 2 * widest)
    throw InputError(Fault{
        "jar", "a ball of half the box's width touches another ball and its periodic image at once",
        "give smaller balls or a larger box", "periodic-box"});
  for (double& d : diameters) d += 2 * skin;
  return std::make_unique<HierarchicalGrid>(-0.5 * size, size, periodic, diameters, slack, balls);
}

}  // namespace

ManyBalls::ManyBalls(std::unique_ptr<const MovingWall> jar, const std::vector<scene::Ball>& balls,
                     const Rules& rules, const contact::BounceTable& bounces, double start)
    : jar_(std::move(jar)),
      rules_(rules),
      tc_rule_{rules.contact_time, rules.sustained_friction},
      bounces_(bounces),
      gravity_(jar_->gravity()),
      periods_(jar_->periods()),
      walls_(jar_->faces() > 0),
      periodic_(periods_.x < never),
      max_acceleration_(jar_->motion_bounds().acceleration + componentwise_abs(gravity_)),
      pressing_acceleration_(
          kinematics::strongest_field(gravity_, jar_->motion_bounds().acceleration, jar_->period(),
                                      [&](double t) { return jar_->frame_motion(t); })),
      start_(start),
      contacts_(balls.size(), 0) {
  const double period = jar_->repeats() ? jar_->period() : never;
  clock_origin_ = std::isfinite(period) ? std::floor(start / period) * period : start;
  now_ = start - clock_origin_;
  epoch_ = jar_->frame_motion(motion_time(0));
  std::map<std::tuple<double, double, std::int32_t, double>, std::uint32_t> known;
  for (const scene::Ball& ball : balls) {
    const auto [place, is_new] = known.try_emplace(
        {ball.radius, ball.density, ball.kind, ball.inertia_ratio}, species_.size());
    if (is_new) {
      species_.push_back(
          {ball.radius, ball.mass(), ball.inertia(), ball.density, ball.kind, ball.inertia_ratio});
      radii_.push_back(ball.radius);
      tolerances_.push_back(tolerance(*jar_, ball.radius));
    }
    Trajectory trajectory{.position = ball.position,
                          .since = now_,
                          .velocity = ball.velocity,
                          .revision = 0,
                          .species = place->second};
    const JarOffset d = jar_offset_at(now_);
    trajectory.position = nearest_image(trajectory.position + d.position, periods_);
    trajectory.velocity += d.velocity;
    collision_data_.push_back(
        {ball.spin, -never, 0, static_cast<std::int32_t>(trajectories_.size())});
    trajectories_.push_back(trajectory);
  }
  contacts_ = ContactRecords(balls.size(), longest_joining_time());
  predictions_.resize(trajectories_.size());
  double ball_volume = 0;
  for (const scene::Ball& ball : balls)
    ball_volume += 4.0 / 3 * std::numbers::pi * ball.radius * ball.radius * ball.radius;
  const double skin = neighbour_skin(*jar_, max_acceleration_.total, radii_, ball_volume);
  grid_ = make_grid(*jar_, max_acceleration_.total, radii_, trajectories_.size(), skin);
  if (skin > 0)
    lists_ = std::make_unique<NeighbourLists>(radii_, skin, periods_, trajectories_.size());
  make_neighbourhoods();
  predict_all();
  finished_.reserve(2048);
  energy_balance_ = energy_balance();
  energy_balance_.initial_energy = energy_balance_.kinetic + energy_balance_.potential;
}

void ManyBalls::predict_all() {
  for (std::int32_t ball = 0; ball < std::ssize(trajectories_); ++ball)
    predict(ball, candidates(ball));
  rebuild_queue();
}

void ManyBalls::predict_and_schedule(std::int32_t ball, std::span<const std::int32_t> others) {
  predict(ball, others);
  queue_.schedule(ball, prediction_of(ball).next());
}

/// Predicts all events of a ball after its trajectory has changed. `others` are its candidates().
void ManyBalls::predict(std::int32_t ball, std::span<const std::int32_t> others) {
  Prediction& p = prediction_of(ball);
  predict_collisions(ball, others);
  const BallState where = ball_state(ball);
  p.face = -1;
  p.wall_check_time = now_ + neighbourhood_safe_time(ball, where);
  if (walls_) {
    const double t = motion_time(now_);
    const WallPrediction predicted =
        jar_->predict_touch(where, t, t, tolerances_[trajectory(ball).species]);
    p.wall_check_time = std::min(p.wall_check_time, predicted.time - motion_time(0));
    if (predicted.face >= 0) p.face = predicted.face;
  }
}

void ManyBalls::predict_collisions(std::int32_t ball, std::span<const std::int32_t> others) {
  prediction_of(ball).collision_time = never;
  predict_collisions_with(ball, others);
}

/// All balls that the ball can touch before it leaves its cell or its sphere, and possibly more.
/// Valid until the next call with the same `buffer`, 0 or 1.
std::span<const std::int32_t> ManyBalls::candidates(std::int32_t ball, std::size_t buffer) {
  return lists_ != nullptr ? lists_->of(ball)
                           : grid_->near(level(ball), prediction_of(ball).cell, buffer);
}

/// Keeps the earliest collision of the ball with one of `others` if it is before the known one.
void ManyBalls::predict_collisions_with(std::int32_t ball, std::span<const std::int32_t> others) {
  const Trajectory& me = trajectory(ball);
  Prediction& p = prediction_of(ball);
  const CollisionQuery query{me.at(now_), me.velocity, now_, species(me).radius, ball};
  const PredictedCollision known{p.collision_time, p.partner};
  const Vec3 none{never, never, never};
  const PredictedCollision found =
      grid_->needs_all_images()
          ? first_of_images(query, others, known)
          : earliest_collision_(query, trajectories_, others, radii_,
                                grid_->is_interior(level(ball), p.cell) ? none : periods_, known);
  if (found.time < p.collision_time)
    p = {found.time,        found.partner, trajectory(found.partner).revision,
         p.wall_check_time, p.face,        p.cell};
}

/// Tests all images that can collide while both balls are in the box: in a box of few cells the
/// nearest image need not be the one that collides first.
PredictedCollision ManyBalls::first_of_images(const CollisionQuery& query,
                                              std::span<const std::int32_t> others,
                                              PredictedCollision found) const {
  const Vec3 none{never, never, never};
  for (const double x : {0.0, -periods_.x, periods_.x})
    for (const double y : {0.0, -periods_.y, periods_.y})
      for (const double z : {0.0, -periods_.z, periods_.z}) {
        CollisionQuery image = query;
        image.position += Vec3{x, y, z};
        found = earliest_collision_(image, trajectories_, others, radii_, none, found);
      }
  return found;
}

/// Restarts the ball's trajectory at the present time, with its position folded into the box.
void ManyBalls::advance_to_now(std::int32_t ball) {
  Trajectory& path = trajectory(ball);
  path.position = nearest_image(path.at(now_), periods_);
  path.since = now_;
}

/// Turns the clock back by `shift` [s]. The falling frame starts again from the jar frame of that
/// time (man.3).
void ManyBalls::move_frame(double shift) {
  const JarOffset d = jar_offset_at(shift);
  for (Trajectory& path : trajectories_) {
    path.since -= shift;
    path.position -= d.position + path.since * d.velocity;
    path.velocity -= d.velocity;
  }
  for (Prediction& p : predictions_) {
    p.collision_time -= shift;
    p.wall_check_time -= shift;
  }
  for (CollisionData& data : collision_data_) data.last_collision -= shift;
  clock_origin_ += shift;
  now_ -= shift;
  epoch_ = jar_->frame_motion(motion_time(0));
  jar_offset_ = {};
}

ManyBalls::JarOffset ManyBalls::jar_offset_at(double t) const {
  if (!walls_) return {t, {}, {}};
  const kinematics::FrameMotion frame = jar_->frame_motion(motion_time(t));
  return {t, frame.centre - epoch_.centre - t * (epoch_.velocity + 0.5 * t * gravity_),
          frame.velocity - epoch_.velocity - t * gravity_};
}

const ManyBalls::JarOffset& ManyBalls::jar_offset() {
  if (jar_offset_.time != now_) jar_offset_ = jar_offset_at(now_);
  return jar_offset_;
}

/// Present state of a ball in the jar frame.
BallState ManyBalls::ball_state(std::int32_t ball) {
  const Trajectory& path = trajectory(ball);
  return {nearest_image(path.at(now_) - jar_offset().position, periods_),
          path.velocity - jar_offset().velocity};
}

}  // namespace mahlwerk::event
