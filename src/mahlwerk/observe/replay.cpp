// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/replay.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

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

/// A total order, so that it does not matter which of two hits comes first.
bool stronger(const ReplayHit& a, const ReplayHit& b) {
  const auto rank = [](const ReplayHit& hit) {
    return std::tuple(-hit.energy, hit.time, hit.ball, hit.other);
  };
  return rank(a) < rank(b);
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
    spins_.push_back(static_cast<float>(norm(balls[i].spin)));
  }
}

std::size_t Replay::hits_in_interval() const {
  return std::clamp<std::size_t>(max_hits / intervals(), 1, 100);
}

void Replay::add_hits(std::span<const scene::Collision> finished, double threshold) {
  if (frames_ < 2) return;
  const double end = begin_ + frame_interval_ * static_cast<double>(intervals());
  for (const scene::Collision& hit : finished) {
    if (!(hit.time >= begin_ && hit.time < end)) continue;
    if (hit.energy_normal() > 0) keep(hit);
    if (hit.approach < threshold) continue;
    count(hit.ball);
    count(hit.other);
  }
}

void Replay::keep(const scene::Collision& hit) {
  const std::size_t most = hits_in_interval();
  hits_.resize(most * intervals());
  kept_.resize(intervals());
  const auto interval =
      std::min(static_cast<std::size_t>((hit.time - begin_) / frame_interval_), intervals() - 1);
  const auto first = hits_.begin() + static_cast<std::ptrdiff_t>(most * interval);
  const ReplayHit one{hit.time, hit.energy_normal(), hit.where, hit.ball, hit.other};
  auto last = first + kept_[interval];
  if (kept_[interval] == most) {
    if (!stronger(one, *first)) return;
    std::pop_heap(first, last, stronger);
    --last;
  } else {
    ++kept_[interval];
  }
  *last = one;
  std::push_heap(first, last + 1, stronger);
}

void Replay::count(std::int32_t ball) {
  if (ball < 0 || static_cast<std::size_t>(ball) % ball_stride_ != 0) return;
  const std::size_t shown = static_cast<std::size_t>(ball) / ball_stride_;
  if (shown >= shown_balls_) return;  // a fragment of a grain
  hits_of_balls_.resize(shown_balls_);
  ++hits_of_balls_[shown];
}

std::vector<ReplayHit> Replay::hits() const {
  std::vector<ReplayHit> list;
  for (std::size_t i = 0; i < kept_.size(); ++i) {
    const auto first = hits_.begin() + static_cast<std::ptrdiff_t>(hits_in_interval() * i);
    list.insert(list.end(), first, first + kept_[i]);
  }
  std::ranges::sort(list, {}, [](const ReplayHit& hit) {
    return std::tuple(hit.time, hit.ball, hit.other, hit.energy);
  });
  return list;
}

void Replay::serialize(Archive& archive) {
  archive(times_)(mill_times_)(positions_)(speeds_)(spins_)(due_);
  archive(hits_)(kept_)(hits_of_balls_);
  if (archive.reading() && !hits_are_whole()) throw Archive::broken();
}

/// Whether what was read fits the film.
bool Replay::hits_are_whole() const {
  if (!hits_of_balls_.empty() && hits_of_balls_.size() != shown_balls_) return false;
  if (kept_.empty() || frames_ < 2) return kept_.empty() && hits_.empty();
  const std::size_t most = hits_in_interval();
  return kept_.size() == intervals() && hits_.size() == most * intervals() &&
         std::ranges::all_of(kept_, [&](std::uint32_t count) { return count <= most; }) &&
         std::ranges::all_of(hits_, [](const ReplayHit& hit) {
           return std::isfinite(hit.time) && std::isfinite(hit.energy);
         });
}

}  // namespace mahlwerk::observe
