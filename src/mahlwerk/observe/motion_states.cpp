// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/motion_states.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/kinematics/arc_shaker.hpp"
#include "mahlwerk/kinematics/figure_eight.hpp"
#include "mahlwerk/kinematics/vibration.hpp"

namespace mahlwerk::observe {
namespace {

constexpr double half_turn = std::numbers::pi;
constexpr std::int64_t lasting = 3;  // periods after which a change of state counts

/// [m] Way of the centre of a ball of `radius` between the ends of the jar, along its axis.
double free_length(const geometry::AnyShape& shape, double radius) {
  double inside = 0, outside = geometry::reach(shape);
  for (int i = 0; i < 50; ++i) {
    const double z = 0.5 * (inside + outside);
    (geometry::nearest_wall(shape, {0, 0, z}, radius) > radius ? inside : outside) = z;
  }
  return 2 * inside;
}

Vec3 least_of(const Vec3& a, const Vec3& b) {
  return {std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)};
}
Vec3 most_of(const Vec3& a, const Vec3& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace

std::string_view name_of(MotionState state) {
  constexpr std::array<std::string_view, all_motion_states.size()> names{
      "circling", "bouncing", "pinned", "stationary", "irregular"};
  return names[static_cast<std::size_t>(state)];
}

bool has_motion_states(const kinematics::AnyMotion& motion, const geometry::AnyShape& shape,
                       const Vec3& axis) {
  constexpr double lies = 0.1;  // upward component of the jar's axis
  const bool shaken = kinematics::as<kinematics::ArcShaker>(motion) != nullptr ||
                      kinematics::as<kinematics::FigureEight>(motion) != nullptr ||
                      kinematics::as<kinematics::Vibration>(motion) != nullptr;
  return shaken && std::abs(axis.z) < lies && kinematics::bounds(motion).speed > 0 &&
         geometry::axisymmetric(shape) && !std::isfinite(geometry::periods(shape).z);
}

MotionTotals& MotionTotals::operator+=(const MotionTotals& other) {
  time += other.time;
  lost += other.lost;
  hits += other.hits;
  energy += other.energy;
  turned += other.turned;
  axial_ratio += other.axial_ratio;
  return *this;
}

MotionStates::MotionStates(const scene::Chamber& mill)
    : mill_(mill), applies_(has_motion_states(*mill.motion, *mill.shape, mill.mount.ez)) {}

void MotionStates::Path::begin(const Vec3& at, double in_laboratory) {
  angle = math::atan2(at.y, at.x);
  turned = 0;
  least = most = at;
  least_axial = most_axial = in_laboratory;
}

void MotionStates::Path::go_on(const Vec3& at, double in_laboratory) {
  const double now = math::atan2(at.y, at.x);
  turned += std::remainder(now - angle, 2 * half_turn);
  angle = now;
  least = least_of(least, at);
  most = most_of(most, at);
  least_axial = std::min(least_axial, in_laboratory);
  most_axial = std::max(most_axial, in_laboratory);
}

void MotionStates::sample(double time, const std::vector<scene::Ball>& balls,
                          const MotionTotals& so_far) {
  if (!applies_) return;
  if (!paths_.empty() && paths_.size() != balls.size()) throw Archive::broken();
  const kinematics::Pose jar = kinematics::pose(*mill_.motion, time);
  const Rotation own = jar.rotation * mill_.mount;
  const double along = dot(jar.frame.centre, mill_.mount.ez);
  if (paths_.empty()) {
    paths_.resize(balls.size());
    for (const scene::Ball& b : balls)
      free_length_.push_back(free_length_.empty() ||
                                     b.radius != balls[free_length_.size() - 1].radius
                                 ? free_length(*mill_.shape, b.radius)
                                 : free_length_.back());
  }
  jar_least_ = std::min(jar_least_, along);
  jar_most_ = std::max(jar_most_, along);
  const auto each = [&](const auto& act) {
    for (std::size_t i = 0; i < balls.size(); ++i)
      act(paths_[i], own.apply_inverse(balls[i].position),
          along + dot(balls[i].position, mill_.mount.ez));
  };
  if (taken_ > 0) each([](Path& path, const Vec3& at, double axial) { path.go_on(at, axial); });
  if (taken_ % samples == 0) {
    if (taken_ > 0) end_period(time, so_far);
    begun_ = time;
    at_begin_ = so_far;
    jar_least_ = jar_most_ = along;
    each([](Path& path, const Vec3& at, double axial) { path.begin(at, axial); });
  }
  ++taken_;
}

MotionState MotionStates::state_of(const Path& path, double free_length) const {
  constexpr double from_end_to_end = 0.9;  // of the free length
  constexpr double turns = 0.5;            // in a period
  constexpr double little = 0.3;           // of the travel of the jar
  const double jar = jar_most_ - jar_least_;
  const Vec3 travel = path.most - path.least;
  if (travel.z > from_end_to_end * free_length) return MotionState::bouncing;
  if (std::abs(path.turned) > turns * 2 * half_turn) return MotionState::circling;
  if (norm(travel) < little * jar) return MotionState::pinned;
  if (path.most_axial - path.least_axial < little * jar) return MotionState::stationary;
  return MotionState::irregular;
}

/// Finds the state of each ball, and gives the period to that of more than half of them.
void MotionStates::end_period(double time, const MotionTotals& so_far) {
  const auto balls = static_cast<double>(paths_.size());
  MotionTotals period{.time = time - begun_,
                      .lost = so_far.lost - at_begin_.lost,
                      .hits = so_far.hits - at_begin_.hits,
                      .energy = so_far.energy - at_begin_.energy};
  std::array<std::size_t, all_motion_states.size()> counts{};
  const double travel = jar_most_ - jar_least_;
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    const Path& path = paths_[i];
    ++counts[index(state_of(path, free_length_[i]))];
    period.turned += period.time * std::abs(path.turned) / (2 * half_turn) / balls;
    period.axial_ratio += period.time * (path.most_axial - path.least_axial) / travel / balls;
  }
  MotionState most = MotionState::irregular;
  for (const MotionState state : all_motion_states) {
    of_balls_[index(state)] += period.time * static_cast<double>(counts[index(state)]) / balls;
    if (2 * counts[index(state)] > paths_.size()) most = state;
  }
  add_period(most, period);
}

/// Keeps the first periods of a change apart until it lasts.
void MotionStates::add_period(MotionState state, const MotionTotals& period) {
  if (state == now_ && visited_ > 0) {
    in_[index(now_)] += pending_;
    in_[index(now_)] += period;
    pending_ = {};
    since_ = 0;
    return;
  }
  if (state != next_ && since_ > 0) {  // a change that did not last
    in_[index(now_)] += pending_;
    pending_ = {};
    since_ = 0;
  }
  next_ = state;
  pending_ += period;
  if (++since_ < lasting) return;
  now_ = next_;
  ++visits_[index(now_)];
  ++visited_;
  in_[index(now_)] += pending_;
  pending_ = {};
  since_ = 0;
}

double MotionStates::time() const {
  double all = 0;
  for (const MotionTotals& one : in_) all += one.time;
  return all;
}

double MotionStates::time_of_balls() const {
  return std::accumulate(of_balls_.begin(), of_balls_.end(), 0.0);
}

void MotionStates::serialize(Archive& archive) {
  if (!applies_) return;
  archive(taken_)(begun_)(
      at_begin_)(jar_least_)(jar_most_)(paths_)(free_length_)(in_)(visits_)(of_balls_)(now_)(next_)(visited_)(since_)(pending_);
  const bool known = std::max(index(now_), index(next_)) < all_motion_states.size();
  if (!known || paths_.size() != free_length_.size()) throw Archive::broken();
}

}  // namespace mahlwerk::observe
