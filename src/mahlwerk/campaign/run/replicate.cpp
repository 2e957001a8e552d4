// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/replicate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/run/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/event/engine.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/series.hpp"
#include "mahlwerk/results/quantities/tables.hpp"
#include "mahlwerk/results/replicate_setup.hpp"

namespace mahlwerk::campaign {
namespace {

event::Rules rules(const cases::Contact& c) {
  const auto lasting = c.lasting == cases::Lasting::roll ? event::Lasting::roll
                       : c.lasting == cases::Lasting::tc ? event::Lasting::tc
                                                         : event::Lasting::none;
  return {
      .bounce = c.rule,
      .faces = {},
      .lasting_friction = c.rule.tangential_restitution == 1 ? 0 : c.lasting_friction,  // (evt.15)
      .rolling_friction = c.rolling_friction,
      .lasting = lasting,
      .lasting_speed = c.lasting_speed,
      .contact_time = c.contact_time};
}

/// The change of everything between two looks, as one row of the time series.
results::Window window(double end, const scene::Account& a, const scene::Account& b,
                       const observe::Sums& all, const observe::Sums& above,
                       const observe::Tally& after) {
  return {.time = end,
          .length = b.time - a.time,
          .collisions = static_cast<double>(after.all.count - all.count),
          .above = static_cast<double>(after.above.count - above.count),
          .energy_normal = after.all.energy_normal - all.energy_normal,
          .energy_contact_point = after.all.energy_contact_point - all.energy_contact_point,
          .lost = b.lost() - a.lost(),
          .wall_work = b.wall_work - a.wall_work,
          .contact_time = b.contact_time - a.contact_time,
          .kinetic = b.kinetic};
}

}  // namespace

/// What is counted, and, if asked for, kept.
class Replica::Ears final : public scene::Observer {
 public:
  explicit Ears(Replica& replica) : replica_(replica) {}
  void collisions(std::span<const scene::Collision> finished) override {
    if (replica_.stretch_ == 0) return;
    results::Replicate& r = replica_.result_;
    r.tally.collisions(finished);
    if (replica_.streams_)
      r.stream.collisions(finished, r.tally.by_pair, results::stream_energy(*replica_.what_));
    if (replica_.keeper_) replica_.keeper_->collisions(finished);
  }

 private:
  Replica& replica_;
};

namespace {

std::unique_ptr<scene::Engine> make_engine(const cases::Case& what,
                                           const std::vector<scene::Ball>& balls, int threads) {
  const scene::Chamber mill = cases::chamber(what);
  if (what.run.engine == cases::EngineName::soft) {
    soft::Rules rules = soft_settings(what).rules;
    rules.threads = threads;
    return soft::engine(mill, balls, rules, cases::pair_table(what));
  }
  const contact::BounceTable bounces = cases::bounce_table(what);
  event::Rules treatment = rules(what.contact);
  treatment.threshold = what.observe.threshold;
  if (balls.size() > 1) return event::many_balls(mill, balls, treatment, bounces);
  for (int face = 0; face < bounces.faces(); ++face)
    treatment.faces.push_back(bounces.wall(0, face));
  return event::one_ball(mill, balls.front(), treatment);
}

}  // namespace

std::unique_ptr<scene::Engine> engine(const cases::Case& what, int index, int threads,
                                      const std::atomic<bool>* stop) {
  auto made = make_engine(what, cases::starting_balls(what, index, stop), threads);
  made->stop_on(stop);
  return made;
}

namespace {

/// A wait for certainty begins with stretches of this many periods of the mill, or seconds.
double first_window(const cases::Case& what) {
  if (!what.run.until) return what.run.time / Replica::stretches;
  const double period = kinematics::period(*what.mill.motion);
  return std::min(std::isfinite(period) ? period : 0.05, what.run.time / Replica::stretches);
}

}  // namespace

Replica::Replica(const cases::Case& what, int index, std::unique_ptr<scene::Observer> keeper,
                 std::unique_ptr<results::FrameFiles> frames, int threads,
                 const std::atomic<bool>* stop)
    : what_(&what),
      index_(index),
      keeper_(std::move(keeper)),
      frames_(std::move(frames)),
      frame_times_(what),
      result_(results::empty_replicate(what)),
      window_(first_window(what)),
      streams_(what.grinding && what.grinding->method != cases::Grinding::Method::balance),
      engine_(engine(what, index, threads, stop)),
      stretch_(what.run.settle > 0 ? 0 : 1) {
  for (const cases::BallSet& set : what.balls) balls_ += set.count;
  const scene::Chamber mill = cases::chamber(what);
  result_.charge = observe::Charge(mill, result_.tally.wall_map.grid().radius);
  if (index == 0)
    result_.replay =
        observe::Replay(mill, static_cast<std::size_t>(balls_), what.run.settle, what.run.time);
  last_ = result_.account = result_.at_settled = engine_->account();
  // The soft engine's work is known beforehand: below 0.1 s for 1000 balls.
  if (what.run.engine == cases::EngineName::soft)
    portion_ = std::min(portion_, 1e3 * soft_settings(what).rules.time_step);
}

double Replica::end_of(int stretch) const {
  const bool last = !what_->run.until && stretch == stretches;
  return what_->run.settle + (last ? what_->run.time : window_ * stretch);
}

/// All stretches are done, or there is certainty, or no more time for it.
bool Replica::over() const {
  if (!what_->run.until) return stretch_ > stretches;
  return enough_ || end_of(stretch_) > (what_->run.settle + what_->run.time) * (1 + 1e-12);
}

bool Replica::done() const {
  return over() || !result_.stopped.empty();
}

/// To `time`, or to where physics stops it.
void Replica::advance(double time) {
  Ears ears(*this);
  try {
    engine_->advance(time, ears);
  } catch (const RunError& e) {
    result_.stopped = fmt::format("{}. The balls as they were then: {}.csv", e.what(),
                                  results::stopped_name(index_));
    result_.at_stop = engine_->balls();
  }
  result_.account = engine_->account();
}

/// Times at which the charge is looked at, spread so that they meet a periodic motion in all its
/// phases.
double Replica::next_look() const {
  if (stretch_ == 0 || looked_ == looks_) return std::numeric_limits<double>::infinity();
  constexpr double golden = 0.6180339887498949;  // (obs.6)
  const double jitter = std::fmod(golden * static_cast<double>(looked_ever_ + 1), 1.0);
  return end_of(stretch_ - 1) + window_ * (looked_ + jitter) / looks_;
}

/// So many looks in the next stretch that they cost little beside its work.
void Replica::plan_looks(const scene::Account& before, const scene::Account& now) {
  constexpr std::int64_t steps = 512, collisions = 200, most = 20;
  const std::int64_t work = what_->run.engine == cases::EngineName::soft
                                ? (now.time_steps - before.time_steps) / steps
                                : (now.collisions - before.collisions) / (collisions * balls_);
  looks_ = static_cast<int>(std::clamp<std::int64_t>(work, 1, most));
  looked_ = 0;
}

/// What is due at the time reached: frames, the film of the report, looks at the charge.
void Replica::look() {
  if (!result_.stopped.empty()) return;
  const double time = result_.account.time;
  const bool frame = frames_ && frame_times_.next() <= time, film = result_.replay.next() <= time,
             charge = next_look() <= time;
  if (!frame && !film && !charge) return;
  const std::vector<scene::Ball> balls = engine_->balls();
  for (; frames_ && frame_times_.next() <= time; frame_times_.go_on())
    frames_->add(time, balls, engine_->forces());
  while (result_.replay.next() <= time) result_.replay.add(time, balls);
  for (; next_look() <= time; ++looked_, ++looked_ever_)
    result_.charge.look(time, balls, window_ / looks_);
}

void Replica::go_on() {
  using Clock = std::chrono::steady_clock;
  const double end = end_of(stretch_);
  const double stop =
      std::min({end, frames_ ? frame_times_.next() : end, result_.replay.next(), next_look()});
  const Clock::time_point began = Clock::now();
  advance(std::min(stop, result_.account.time + portion_));
  look();
  const double worked = std::chrono::duration<double>(Clock::now() - began).count();
  portion_ *= worked < 0.025 ? 2 : worked > 0.1 ? 0.25 : 1;
  portion_ = std::min(std::max(portion_, 1e-15), what_->run.settle + what_->run.time);
  if (result_.account.time >= end || !result_.stopped.empty()) end_stretch();
}

void Replica::end_stretch() {
  if (stretch_ == 0)
    result_.at_settled = result_.account;
  else
    result_.windows.push_back(window(result_.account.time - what_->run.settle, last_,
                                     result_.account, all_, above_, result_.tally));
  plan_looks(last_, result_.account);
  last_ = result_.account;
  all_ = result_.tally.all;
  above_ = result_.tally.above;
  ++stretch_;
  if (!what_->run.until || !result_.stopped.empty()) return;
  if (std::ssize(result_.windows) == stretches) {
    result_.windows = results::joined_in_twos(result_.windows);
    window_ *= 2;
    stretch_ = stretches / 2 + 1;
  }
  constexpr int fewest = 50, between = 10;
  if (std::ssize(result_.windows) < fewest || stretch_ % between != 1) return;
  const observe::Estimate known =
      observe::over_time(results::series(result_.windows, what_->run.until->quantity));
  enough_ = known.ci95 <= what_->run.until->within * std::abs(known.mean);
}

results::Replicate Replica::result() const {
  results::Replicate given = result_;
  given.complete = over() && given.stopped.empty();
  given.sure = !what_->run.until || enough_;
  if (!given.complete) end_early(given);
  results::grind(*what_, given, index_);
  return given;
}

/// What was counted of the stretch that did not end.
void Replica::end_early(results::Replicate& given) const {
  if (stretch_ == 0)
    given.at_settled = given.account;
  else if (given.account.time > last_.time)
    given.windows.push_back(window(given.account.time - what_->run.settle, last_, given.account,
                                   all_, above_, given.tally));
}

void Replica::carry(Archive& archive) {
  results::Replicate& r = result_;
  r.tally.carry(archive);
  r.charge.carry(archive);
  r.replay.carry(archive);
  r.stream.carry(archive);
  archive(r.windows)(r.account)(r.at_settled)(r.stopped)(r.at_stop)(r.cpu_seconds);
  archive(stretch_)(last_)(all_)(above_)(window_)(enough_)(looks_)(looked_)(looked_ever_);
  engine_->carry(archive);
}

}  // namespace mahlwerk::campaign
