// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/many_balls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/event/guard.hpp"

namespace mahlwerk::event {
namespace {

constexpr std::size_t max_records = 1024;       // records per call of the observer
constexpr std::int64_t collisions_between = 2;  // per ball, between two reorganisations
constexpr std::int64_t collisions_at_least = 500;
constexpr double longest_clock = 1;  // [s] later positions in the falling frame lose digits

}  // namespace

void ManyBalls::advance(double time, scene::Observer& observer) {
  const double until = time + start_;
  try {
    for (;;) {
      horizon_ = until - clock_origin_;
      const ScheduledEvent due = queue_.next();
      if (!(due.time < horizon_)) break;
      if (events_ % 64 == 0 && stopped()) {
        reached_ = std::max(reached_, mill_time() - start_);
        return hand_over(observer);
      }
      now_ = due.time;
      prefetch_next_events();
      process_event(due.ball);
      check_zeno();
      if (finished_.size() >= max_records) hand_over(observer);
      const auto many = collisions_between * std::ssize(trajectories_) + collisions_at_least;
      const auto since = energy_balance_.collisions - collisions_at_reorganisation_;
      if (since > many || (since > 0 && now_ - reorganised_ > longest_clock)) reorganise();
    }
  } catch (...) {
    reached_ = mill_time() - start_;
    hand_over(observer);
    throw;
  }
  reached_ = time;
  contacts_.finish_before(time, finished_);
  hand_over(observer);
}

/// Prefetches the data of the next events in three stages, each of which finds its addresses in
/// what the one before has fetched: the balls of the next slice, the partners of a ball soon due,
/// the candidates of both.
void ManyBalls::prefetch_next_events() {
  if (fits_cache()) return;
  for (int i = 0; i < 2; ++i)
    if (const std::int32_t later = queue_.next_slice_ball(); later >= 0) prefetch_ball(later);
  if (const std::int32_t soon = queue_.upcoming(2); soon >= 0) {
    const Prediction& p = prediction_of(soon);
    if (p.partner >= 0) prefetch_ball(p.partner);
  }
  if (const std::int32_t next = queue_.upcoming(1); next >= 0) {
    const Prediction& p = prediction_of(next);
    prefetch_candidates(next);
    if (p.partner >= 0 && p.collision_time < p.wall_check_time) prefetch_candidates(p.partner);
  }
}

void ManyBalls::prefetch_ball(std::int32_t ball) const {
  const auto i = static_cast<std::size_t>(ball);
  __builtin_prefetch(&predictions_[i]);
  __builtin_prefetch(&trajectories_[i]);
  __builtin_prefetch(&collision_data_[i]);
  if (lists_ != nullptr) lists_->prefetch(ball);
}

void ManyBalls::prefetch_candidates(std::int32_t ball) const {
  if (lists_ != nullptr) return prefetch_trajectories(lists_->of(ball));
  grid_->prefetch(level(ball), predictions_[static_cast<std::size_t>(ball)].cell);
}

void ManyBalls::prefetch_trajectories(std::span<const std::int32_t> balls) const {
  for (const std::int32_t ball : balls)
    __builtin_prefetch(&trajectories_[static_cast<std::size_t>(ball)]);
}

void ManyBalls::process_event(std::int32_t ball) {
  ++events_;
  const Prediction& p = prediction_of(ball);
  if (p.wall_check_time <= p.collision_time)
    check_wall_and_cell(ball);
  else
    process_collision(ball);
}

/// Safe-time query for walls and cell. It searches ahead until the next event of any other ball at
/// most, because nothing changes this ball's flight before.
[[gnu::flatten]] void ManyBalls::check_wall_and_cell(std::int32_t ball) {
  Prediction& p = prediction_of(ball);
  if (p.face >= 0) return hit_wall(ball, p.face);
  if (periodic_) advance_to_now(ball);  // it may have left the box
  const BallState where = ball_state(ball);
  if (has_left(ball, where)) renew_neighbourhood(ball, where);
  const double exit_time = now_ + neighbourhood_safe_time(ball, where);
  p.wall_check_time = exit_time;
  if (walls_) {
    queue_.schedule(ball, never);
    constexpr double max_lookahead =
        0.01;  // [s] bounds the search for a ball at rest that nothing reaches
    const double next_other_event = queue_.next().time;
    const double search_end =
        std::min({p.collision_time, exit_time, next_other_event, now_ + max_lookahead});
    const WallPrediction predicted = jar_->predict_touch(
        where, motion_time(now_), motion_time(search_end), tolerances_[trajectory(ball).species]);
    ++energy_balance_.search_steps;
    // For the Zeno guard, sixteen search steps count as an event.
    if (predicted.face < 0 && predicted.time < motion_time(search_end))
      events_ += max_search_steps / 16;
    const double wall_time = std::max(now_, predicted.time - motion_time(0));
    if (predicted.face >= 0 && wall_time < search_end && wall_time < horizon_) {
      now_ = wall_time;
      return hit_wall(ball, predicted.face);
    }
    if (predicted.face >= 0 || wall_time < exit_time) {
      p.wall_check_time = wall_time;
      p.face = predicted.face;
    }
  }
  queue_.schedule(ball, p.next());
}

/// Collides two balls, unless the partner's trajectory has changed since the prediction (lazy
/// invalidation). Then the collisions of the ball are predicted again.
void ManyBalls::process_collision(std::int32_t ball) {
  Prediction& p = prediction_of(ball);
  if (trajectory(p.partner).revision == p.partner_revision) return hit_ball(ball, p.partner);
  predict_collisions(ball, candidates(ball));
  queue_.schedule(ball, p.next());
}

/// Turns the clock back, stores balls that are neighbours in the jar next to each other in memory,
/// and fits the slice width of the calendar queue to the rate of events.
void ManyBalls::reorganise() {
  const double period = jar_->repeats() ? jar_->period() : never;
  const double shift = std::isfinite(period) ? std::floor(now_ / period) * period : now_;
  if (shift > 0) move_frame(shift);
  sort();
  rebuild_queue();
  reorganised_ = now_;
  collisions_at_reorganisation_ = energy_balance_.collisions;
}

/// Zeno guard: stops a run whose events accumulate in almost no time, with the reason.
void ManyBalls::check_zeno() {
  // A ball at rest has some thirty events in t_c; deep in a bed, several times as many.
  constexpr std::int64_t many = 100'000, each = 2'000;
  constexpr double min_span = 1e-4;  // [s]
  const std::int64_t events = events_ - zeno_first_event_;
  if (events < many + each * std::ssize(trajectories_)) return;
  const double within = mill_time() - zeno_since_;
  if (within < min_span)
    throw zeno_error(mill_time() - start_, within, events, rules_.sustained_mode);
  zeno_first_event_ = events_;
  zeno_since_ = mill_time();
}

void ManyBalls::serialize(Archive& archive) {
  const auto count = trajectories_.size();
  archive(trajectories_)(predictions_)(collision_data_);
  archive(now_)(clock_origin_)(
      epoch_)(reached_)(events_)(collisions_at_reorganisation_)(reorganised_);
  archive(zeno_first_event_)(zeno_since_)(energy_balance_);
  grid_->serialize(archive);
  contacts_.serialize(archive);
  if (lists_ != nullptr) lists_->serialize(archive);
  if (!archive.reading()) return;
  if (!is_consistent(count)) throw Archive::broken();
  jar_offset_ = {};
  rebuild_queue();
}

/// Whether all ball numbers, indices and cells read from an archive are valid for `count` balls.
bool ManyBalls::is_consistent(std::size_t count) {
  if (trajectories_.size() != count || predictions_.size() != count ||
      collision_data_.size() != count)
    return false;
  const auto balls = static_cast<std::int32_t>(count);
  std::vector<bool> named(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Prediction& p = predictions_[i];
    const std::int32_t id = collision_data_[i].id;
    if (trajectories_[i].species >= species_.size() || p.partner < -1 || p.partner >= balls ||
        (p.partner < 0 && p.collision_time < never) || p.face < -1 || p.face >= jar_->faces() ||
        id < 0 || id >= balls || named[static_cast<std::size_t>(id)])
      return false;
    named[static_cast<std::size_t>(id)] = true;
  }
  for (std::int32_t i = 0; i < balls; ++i)
    if (!grid_->contains(level(i), i, prediction_of(i).cell)) return false;
  return grid_->ball_count() == balls && (lists_ == nullptr || lists_->is_consistent(count));
}

void ManyBalls::rebuild_queue() {
  std::vector<double> times(predictions_.size());
  std::ranges::transform(predictions_, times.begin(), &Prediction::next);
  queue_.start(times, now_);
}

void ManyBalls::hand_over(scene::Observer& observer) {
  if (!finished_.empty()) observer.collisions(finished_);
  finished_.clear();
}

}  // namespace mahlwerk::event
