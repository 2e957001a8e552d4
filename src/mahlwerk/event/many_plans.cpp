// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <tuple>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/base/index.hpp"
#include "mahlwerk/event/many_balls.hpp"
#include "mahlwerk/geometry/clear.hpp"
#include "mahlwerk/kinematics/strongest_field.hpp"

namespace mahlwerk::event {
namespace {

Feeler feeler(const Enclosure& jar, double radius) {
  const auto& limits = jar.limits();
  const double scale =
      jar.reach() + jar.offset() +
      (limits.jerk > 0 ? limits.speed * limits.speed / (norm(limits.acceleration) + 1e-300) : 0.0);
  return {radius, std::max(1e-12 * radius, 64 * 0x1p-52 * scale)};
}

/// Grids over the box in which centres of balls can be.
std::unique_ptr<Neighbours> grids(const Enclosure& jar, double pull,
                                  const std::vector<double>& radii, std::size_t balls) {
  const bool periodic = jar.periods().x < at_no_time;
  const Vec3 size = periodic ? jar.periods() : 2 * jar.reach() * Vec3{1, 1, 1};
  // A ball pulled by unknown forces is looked at too early rather than too late, again and again as
  // it nears the border: with some slack it has already crossed it at one of those looks.
  const double slack = pull > 0 ? 0.02 : 1e-7;
  std::vector<double> diameters;
  for (const double r : radii) diameters.push_back(2 * r);
  const double widest = *std::ranges::max_element(diameters);
  if (periodic && std::min({size.x, size.y, size.z}) <= 2 * widest)
    throw InputError(Fault{"jar",
                           "a ball of half a periodic box meets another and its image at once",
                           "give smaller balls or a larger box", "periodic-box"});
  return std::make_unique<Neighbours>(-0.5 * size, size, periodic, diameters, slack, balls);
}

}  // namespace

ManyBalls::ManyBalls(std::unique_ptr<const Enclosure> jar, const std::vector<scene::Ball>& balls,
                     const Rules& rules, const contact::BounceTable& bounces, double start)
    : jar_(std::move(jar)),
      rules_(rules),
      sustained_{rules.contact_time, rules.lasting_friction},
      bounces_(bounces),
      gravity_(jar_->gravity()),
      periods_(jar_->periods()),
      walls_(jar_->faces() > 0),
      periodic_(periods_.x < at_no_time),
      pull_(jar_->limits().acceleration + magnitude(gravity_)),
      press_(kinematics::strongest_field(gravity_, jar_->limits().acceleration, jar_->period(),
                                         [&](double t) { return jar_->ride(t); })),
      start_(start) {
  const double period = jar_->looks_still() ? jar_->period() : at_no_time;
  before_ = std::isfinite(period) ? std::floor(start / period) * period : start;
  now_ = start - before_;
  epoch_ = jar_->ride(motion_time(0));
  std::map<std::tuple<double, double, std::int32_t>, std::uint32_t> known;
  for (const scene::Ball& ball : balls) {
    const auto [place, is_new] =
        known.try_emplace({ball.radius, ball.density, ball.kind}, species_.size());
    if (is_new) {
      species_.push_back({ball.radius, ball.mass(), ball.inertia(), ball.density, ball.kind});
      radii_.push_back(ball.radius);
      feelers_.push_back(feeler(*jar_, ball.radius));
    }
    Line line{.position = ball.position,
              .since = now_,
              .velocity = ball.velocity,
              .bent = 0,
              .species = place->second};
    const Drift d = drift_at(now_);
    line.position = nearest_image(line.position + d.place, periods_);
    line.velocity += d.velocity;
    turnings_.push_back({ball.spin, -at_no_time, 0, static_cast<std::int32_t>(lines_.size())});
    lines_.push_back(line);
  }
  plans_.resize(lines_.size());
  neighbours_ = grids(*jar_, pull_.whole, radii_, lines_.size());
  fill_cells();
  plan_all();
  finished_.reserve(2048);
  account_ = account();
  account_.started_with = account_.kinetic + account_.potential;
}

void ManyBalls::plan_all() {
  for (std::int32_t ball = 0; ball < std::ssize(lines_); ++ball) predict(ball);
  start_calendar();
}

void ManyBalls::plan(std::int32_t ball) {
  predict(ball);
  calendar_.schedule(ball, plan_of(ball).next());
}

/// All of a ball's future, after its way has changed.
void ManyBalls::predict(std::int32_t ball) {
  Plan& p = plan_of(ball);
  plan_meetings(ball);
  const Passing where = passing(ball);
  p.face = -1;
  p.look = now_ + leaves(ball, where);
  if (walls_) {
    const double t = motion_time(now_);
    const Sighting seen = jar_->look(where, t, t, feelers_[line(ball).species]);
    p.look = std::min(p.look, seen.time - motion_time(0));
    if (seen.face >= 0) p.face = seen.face;
  }
}

void ManyBalls::plan_meetings(std::int32_t ball) {
  plan_of(ball).meeting = at_no_time;
  plan_meeting(ball, neighbours_->near(level(ball), plan_of(ball).cell));
}

/// Keeps the ball's earliest meeting, if one of `others` is it.
void ManyBalls::plan_meeting(std::int32_t ball, std::span<const std::int32_t> others) {
  const Line& me = line(ball);
  Plan& p = plan_of(ball);
  const Asking asking{me.at(now_), me.velocity, now_, species(me).radius, ball};
  const Meeting known{p.meeting, p.partner};
  const Meeting found = neighbours_->few()
                            ? first_of_images(asking, others, known)
                            : first_meeting(asking, lines_, others, radii_, periods_, known);
  if (found.time < p.meeting)
    p = {found.time, found.partner, line(found.partner).bent, p.look, p.face, p.cell};
}

/// In a box of few cells the nearest image need not be the one that is met first: all are asked
/// that can be met while both balls are in the box.
Meeting ManyBalls::first_of_images(const Asking& asking, std::span<const std::int32_t> others,
                                   Meeting found) const {
  const Vec3 none{at_no_time, at_no_time, at_no_time};
  for (const double x : {0.0, -periods_.x, periods_.x})
    for (const double y : {0.0, -periods_.y, periods_.y})
      for (const double z : {0.0, -periods_.z, periods_.z}) {
        Asking image = asking;
        image.position += Vec3{x, y, z};
        found = first_meeting(image, lines_, others, radii_, none, found);
      }
  return found;
}

/// How long a ball certainly stays in its cell [s].
double ManyBalls::leaves(std::int32_t ball, const Passing& where) const {
  const Cells::Borders b =
      neighbours_->borders(level(ball), plans_[static_cast<std::size_t>(ball)].cell);
  const Vec3 &v = where.velocity, &a = pull_.most;
  Vec3 x = where.position;
  if (periodic_) {  // seen from the cell: just beyond the border of the box it was folded far away
    const Vec3 middle = 0.5 * (b.low + b.high);
    x = middle + nearest_image(x - middle, periods_);
  }
  const auto along = [](double low, double high, double place, double speed, double pull) {
    double ahead = high - place, behind = place - low;
    if (speed < 0) std::swap(ahead, behind);
    speed = std::abs(speed);
    if (pull == 0) return speed > 0 ? std::max(ahead, 0.0) / speed : at_no_time;
    const double to =
        ahead < at_no_time ? geometry::clear_of_plane(ahead, speed, pull) : at_no_time;
    if (behind >= ahead) return to;  // not reached before the border ahead
    return std::min(to, geometry::clear_of_plane(behind, -speed, pull));
  };
  return std::min({along(b.low.x, b.high.x, x.x, v.x, a.x), along(b.low.y, b.high.y, x.y, v.y, a.y),
                   along(b.low.z, b.high.z, x.z, v.z, a.z)});
}

bool ManyBalls::has_left(std::int32_t ball, const Passing& where) const {
  const Cell cell = plans_[static_cast<std::size_t>(ball)].cell;
  return neighbours_->cell_at(level(ball), where.position) != cell;
}

void ManyBalls::change_cell(std::int32_t ball, const Passing& where) {
  Plan& p = plan_of(ball);
  const Cell before = p.cell, cell = neighbours_->cell_at(level(ball), where.position);
  neighbours_->remove(level(ball), ball, before);
  neighbours_->insert(level(ball), ball, cell);
  p.cell = cell;
  // In a box of few cells those who stay near may be met in another image from now on.
  plan_meeting(ball, neighbours_->few() ? neighbours_->near(level(ball), cell)
                                        : neighbours_->newly_near(level(ball), cell, before));
}

/// Starts the ball's line anew at this moment, in the box.
void ManyBalls::bring_to_now(std::int32_t ball) {
  Line& l = line(ball);
  l.position = nearest_image(l.at(now_), periods_);
  l.since = now_;
}

/// Turns the clock back by `shift` [s] and lets the falling frame start from the jar frame of that
/// time (man.3).
void ManyBalls::move_frame(double shift) {
  const Drift d = drift_at(shift);
  for (Line& l : lines_) {
    l.since -= shift;
    l.position -= d.place + l.since * d.velocity;
    l.velocity -= d.velocity;
  }
  for (Plan& p : plans_) {
    p.meeting -= shift;
    p.look -= shift;
  }
  for (Turning& t : turnings_) t.last -= shift;
  before_ += shift;
  now_ -= shift;
  epoch_ = jar_->ride(motion_time(0));
  drift_ = {};
}

/// Stores the balls in the order of their cells.
void ManyBalls::sort() {
  const auto count = lines_.size();
  if (count < 512) return;
  std::vector<std::int32_t> order(count), place(count);
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](std::int32_t i) {
    return std::pair{level(i), plan_of(i).cell};
  });
  for (std::size_t i = 0; i < count; ++i) place[as_index(order[i])] = static_cast<std::int32_t>(i);
  const auto permute = [&](auto& list) {
    std::remove_reference_t<decltype(list)> sorted;
    sorted.reserve(count);
    for (const std::int32_t i : order) sorted.push_back(list[as_index(i)]);
    list = std::move(sorted);
  };
  permute(lines_);
  permute(plans_);
  permute(turnings_);
  neighbours_->clear();
  for (std::int32_t ball = 0; ball < std::ssize(lines_); ++ball) {
    Plan& p = plan_of(ball);
    if (p.partner >= 0) p.partner = place[as_index(p.partner)];
    neighbours_->insert(level(ball), ball, p.cell);
  }
}

void ManyBalls::fill_cells() {
  neighbours_->clear();
  for (std::int32_t ball = 0; ball < std::ssize(lines_); ++ball) {
    plan_of(ball).cell = neighbours_->cell_at(level(ball), passing(ball).position);
    neighbours_->insert(level(ball), ball, plan_of(ball).cell);
  }
}

ManyBalls::Drift ManyBalls::drift_at(double t) const {
  if (!walls_) return {t, {}, {}};
  const kinematics::Ride ride = jar_->ride(motion_time(t));
  return {t, ride.centre - epoch_.centre - t * (epoch_.velocity + 0.5 * t * gravity_),
          ride.velocity - epoch_.velocity - t * gravity_};
}

const ManyBalls::Drift& ManyBalls::drift() {
  if (drift_.time != now_) drift_ = drift_at(now_);
  return drift_;
}

/// Where a ball is now, in the jar frame.
Passing ManyBalls::passing(std::int32_t ball) {
  const Line& l = line(ball);
  return {nearest_image(l.at(now_) - drift().place, periods_), l.velocity - drift().velocity};
}

}  // namespace mahlwerk::event
