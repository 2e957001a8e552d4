// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/event/many_balls.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "mahlwerk/event/guard.hpp"

namespace mahlwerk::event {
namespace {

constexpr std::size_t chunk = 1024;             // records handed over at a time
constexpr std::int64_t collisions_between = 2;  // per ball, from one renewal to the next
constexpr std::int64_t collisions_at_least = 500;
constexpr double longest_clock = 1;  // [s] beyond it the falling frame gets far away

}  // namespace

void ManyBalls::advance(double time, scene::Observer& observer) {
  const double until = time + start_;
  try {
    for (;;) {
      horizon_ = until - before_;
      const Due due = calendar_.next();
      if (!(due.time < horizon_)) break;
      if (events_ % 64 == 0 && stopped()) {
        reached_ = std::max(reached_, mill_time() - start_);
        return hand_over(observer);
      }
      now_ = due.time;
      fetch_ahead();
      happen(due.ball);
      guard();
      if (finished_.size() >= chunk) hand_over(observer);
      const auto many = collisions_between * std::ssize(lines_) + collisions_at_least;
      const auto since = account_.collisions - renewed_collisions_;
      if (since > many || (since > 0 && now_ - renewed_ > longest_clock)) renew();
    }
  } catch (...) {
    reached_ = mill_time() - start_;
    hand_over(observer);
    throw;
  }
  reached_ = time;
  hand_over(observer);
}

/// Whose turn comes soon is in memory somewhere far away: it is sent for in time.
void ManyBalls::fetch_ahead() const {
  constexpr std::size_t near_at_hand = 4096;  // so many balls stay in the processor's own memory
  if (lines_.size() <= near_at_hand) return;
  if (const std::int32_t later = calendar_.coming(3); later >= 0) {
    const auto i = static_cast<std::size_t>(later);
    __builtin_prefetch(&plans_[i]);
    __builtin_prefetch(&lines_[i]);
    __builtin_prefetch(&turnings_[i]);
  }
  if (const std::int32_t soon = calendar_.coming(1); soon >= 0) {
    const Plan& p = plans_[static_cast<std::size_t>(soon)];
    if (p.partner >= 0) {
      __builtin_prefetch(&lines_[static_cast<std::size_t>(p.partner)]);
      __builtin_prefetch(&plans_[static_cast<std::size_t>(p.partner)]);
      __builtin_prefetch(&turnings_[static_cast<std::size_t>(p.partner)]);
    }
    neighbours_->fetch(level(soon), p.cell);
  }
}

void ManyBalls::happen(std::int32_t ball) {
  ++events_;
  const Plan& p = plan_of(ball);
  if (p.look <= p.meeting)
    look(ball);
  else
    meet(ball);
}

/// A ball may be near a wall or about to leave its cell. It is followed as long as nobody else's
/// turn comes.
void ManyBalls::look(std::int32_t ball) {
  Plan& p = plan_of(ball);
  if (p.face >= 0) return hit_wall(ball, p.face);
  if (periodic_) bring_to_now(ball);  // it may have left the box
  const Passing where = passing(ball);
  if (has_left(ball, where)) change_cell(ball, where);
  const double left = now_ + leaves(ball, where);
  p.look = left;
  if (walls_) {
    calendar_.schedule(ball, at_no_time);
    constexpr double ahead =
        0.01;  // [s] a ball at rest that nothing reaches is not sought for ever
    const double next = calendar_.next().time;
    const double alone = std::min({p.meeting, left, next, now_ + ahead});
    const Sighting seen =
        jar_->look(where, motion_time(now_), motion_time(alone), feelers_[line(ball).species]);
    ++account_.search_steps;
    if (seen.face < 0 && seen.time < motion_time(alone)) events_ += most_search_steps / 16;
    const double then = std::max(now_, seen.time - motion_time(0));
    if (seen.face >= 0 && then < alone && then < horizon_) {
      now_ = then;
      return hit_wall(ball, seen.face);
    }
    if (seen.face >= 0 || then < left) {
      p.look = then;
      p.face = seen.face;
    }
  }
  calendar_.schedule(ball, p.next());
}

/// Two balls meet, unless the partner has changed its way since that was predicted.
void ManyBalls::meet(std::int32_t ball) {
  Plan& p = plan_of(ball);
  if (line(p.partner).bent == p.partner_bent) return hit_ball(ball, p.partner);
  plan_meetings(ball);
  calendar_.schedule(ball, p.next());
}

/// From time to time the clock is turned back, balls that are neighbours in the jar become
/// neighbours in memory, and the calendar's slices get the width that suits the rate of events.
void ManyBalls::renew() {
  const double period = jar_->looks_still() ? jar_->period() : at_no_time;
  const double shift = std::isfinite(period) ? std::floor(now_ / period) * period : now_;
  if (shift > 0) move_frame(shift);
  sort();
  start_calendar();
  renewed_ = now_;
  renewed_collisions_ = account_.collisions;
}

/// A run whose events pile up without end stops with the reason, rather than hang.
void ManyBalls::guard() {
  // A ball at rest makes some thirty in t_c; deep in a bed, several times as many.
  constexpr std::int64_t many = 100'000, each = 2'000;
  constexpr double soon = 1e-4;  // [s]
  const std::int64_t events = events_ - guarded_;
  if (events < many + each * std::ssize(lines_)) return;
  const double within = mill_time() - guarded_since_;
  if (within < soon) throw pile_up(mill_time() - start_, within, events, rules_.lasting);
  guarded_ = events_;
  guarded_since_ = mill_time();
}

void ManyBalls::carry(Archive& archive) {
  const auto count = lines_.size();
  archive(lines_)(plans_)(turnings_);
  archive(now_)(before_)(epoch_)(reached_)(events_)(renewed_collisions_)(renewed_);
  archive(guarded_)(guarded_since_)(account_);
  neighbours_->carry(archive);
  if (!archive.reading()) return;
  if (!holds_together(count)) throw Archive::broken();
  drift_ = {};
  start_calendar();
}

/// Whether all that tells who is who, or where in memory, can be so for `count` balls.
bool ManyBalls::holds_together(std::size_t count) {
  if (lines_.size() != count || plans_.size() != count || turnings_.size() != count) return false;
  const auto balls = static_cast<std::int32_t>(count);
  std::vector<bool> named(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Plan& p = plans_[i];
    const std::int32_t name = turnings_[i].name;
    if (lines_[i].species >= species_.size() || p.partner < -1 || p.partner >= balls ||
        (p.partner < 0 && p.meeting < at_no_time) || p.face < -1 || p.face >= jar_->faces() ||
        name < 0 || name >= balls || named[static_cast<std::size_t>(name)])
      return false;
    named[static_cast<std::size_t>(name)] = true;
  }
  for (std::int32_t i = 0; i < balls; ++i)
    if (!neighbours_->holds(level(i), i, plan_of(i).cell)) return false;
  return neighbours_->held() == balls;
}

void ManyBalls::start_calendar() {
  std::vector<double> times(plans_.size());
  std::ranges::transform(plans_, times.begin(), &Plan::next);
  calendar_.start(times, now_);
}

void ManyBalls::hand_over(scene::Observer& observer) {
  if (!finished_.empty()) observer.collisions(finished_);
  finished_.clear();
}

}  // namespace mahlwerk::event
