// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace mahlwerk::observe {
namespace {

constexpr std::size_t max_frames = 360, fewest_frames = 16;

/// [s] Duration of a replay that shows the motion.
double film_duration(const kinematics::AnyMotion& motion) {
  constexpr double periods = 3, otherwise = 0.5;
  const double spin = kinematics::bounds(motion).spin;
  const double turn = spin > 0 ? 2 * std::numbers::pi / spin : otherwise;
  const double period = kinematics::period(motion);
  return std::isfinite(period) ? periods * period : std::min(turn, 10.0);
}

std::int16_t rounded(double value, double unit) {
  constexpr double most = std::numeric_limits<std::int16_t>::max();
  return static_cast<std::int16_t>(std::lround(std::clamp(value / unit, -most, most)));
}

}  // namespace

Replay::Replay(const scene::Chamber& mill, std::size_t balls, double begin, double most,
               double shortest)
    : begin_(begin), ball_stride_(1 + (balls - 1) / max_balls) {
  shown_balls_ = (balls + ball_stride_ - 1) / ball_stride_;
  frames_ = std::clamp(max_positions / shown_balls_, fewest_frames, max_frames);
  const double length = std::min(film_duration(*mill.motion), most);
  frame_interval_ = std::max(shortest, length / static_cast<double>(frames_ - 1));
  frames_ = std::min(frames_, 1 + static_cast<std::size_t>(most / frame_interval_ + 1e-9));
  position_unit_ = geometry::reach(*mill.shape) / 32767;
}

double Replay::next_frame_time() const {
  if (due_ == frames_) return std::numeric_limits<double>::infinity();
  return begin_ + frame_interval_ * static_cast<double>(due_);
}

void Replay::add(double time, double mill_time, const std::vector<scene::Ball>& balls) {
  ++due_;
  if (!times_.empty() && !(time > times_.back())) return;
  times_.push_back(time);
  mill_times_.push_back(mill_time);
  for (std::size_t i = 0; i < balls.size(); i += ball_stride_) {
    const Vec3& p = balls[i].position;
    positions_.push_back(balls[i].outside ? outside
                                          : std::array{rounded(p.x, position_unit_),
                                                       rounded(p.y, position_unit_),
                                                       rounded(p.z, position_unit_)});
    speeds_.push_back(static_cast<float>(norm(balls[i].velocity)));
  }
}

void Replay::serialize(Archive& archive) {
  archive(times_)(mill_times_)(positions_)(speeds_)(due_);
}

}  // namespace mahlwerk::observe
