// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/replicate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "mahlwerk/base/error.hpp"
#include "mahlwerk/campaign/soft_settings.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/event/engine.hpp"
#include "mahlwerk/results/tables.hpp"

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

/// Who is of which set; a single ball has one kind of pair, which needs no table.
observe::BallKinds kinds(const cases::Case& what) {
  std::vector<std::int32_t> of_ball = cases::kinds_of_balls(what);
  if (of_ball.size() < 2) return {};
  return {std::move(of_ball), static_cast<int>(what.balls.size())};
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
    replica_.result_.tally.collisions(finished);
    if (replica_.keeper_) replica_.keeper_->collisions(finished);
  }

 private:
  Replica& replica_;
};

std::unique_ptr<scene::Engine> engine(const cases::Case& what, int index, int threads) {
  const scene::Chamber mill = cases::chamber(what);
  const std::vector<scene::Ball> balls = cases::starting_balls(what, index);
  if (what.run.engine == "soft") {
    soft::Rules rules = soft_settings(what).rules;
    rules.threads = threads;
    return soft::engine(mill, balls, rules, cases::pair_table(what));
  }
  const contact::BounceTable bounces = cases::bounce_table(what);
  event::Rules treatment = rules(what.contact);
  if (balls.size() > 1) return event::many_balls(mill, balls, treatment, bounces);
  for (int face = 0; face < bounces.faces(); ++face)
    treatment.faces.push_back(bounces.wall(0, face));
  return event::one_ball(mill, balls.front(), treatment);
}

Replica::Replica(const cases::Case& what, int index, std::unique_ptr<scene::Observer> keeper,
                 std::unique_ptr<results::FrameFiles> frames, int threads)
    : what_(&what),
      index_(index),
      keeper_(std::move(keeper)),
      frames_(std::move(frames)),
      frame_times_(what),
      result_(what.observe.threshold, kinds(what)),
      engine_(engine(what, index, threads)),
      stretch_(what.run.settle > 0 ? 0 : 1) {
  last_ = result_.account = result_.at_settled = engine_->account();
  if (what.run.engine == "soft")  // its work is known beforehand: below 0.1 s for 1000 balls
    portion_ = std::min(portion_, 1e3 * soft_settings(what).rules.time_step);
}

double Replica::end_of(int stretch) const {
  return what_->run.settle + what_->run.time * stretch / stretches;
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

/// Those that are due at the time reached.
void Replica::add_frames() {
  if (!frames_ || !result_.stopped.empty()) return;
  for (; frame_times_.next() <= result_.account.time; frame_times_.go_on())
    frames_->add(result_.account.time, engine_->balls(), engine_->forces());
}

void Replica::go_on() {
  using Clock = std::chrono::steady_clock;
  const double end = end_of(stretch_);
  const double stop = frames_ ? std::min(end, frame_times_.next()) : end;
  const Clock::time_point began = Clock::now();
  advance(std::min(stop, result_.account.time + portion_));
  add_frames();
  const double worked = std::chrono::duration<double>(Clock::now() - began).count();
  portion_ *= worked < 0.025 ? 2 : worked > 0.1 ? 0.25 : 1;
  portion_ = std::min(std::max(portion_, 1e-15), end_of(stretches));
  if (result_.account.time < end && result_.stopped.empty()) return;
  if (stretch_ == 0)
    result_.at_settled = result_.account;
  else
    result_.windows.push_back(window(result_.account.time - what_->run.settle, last_,
                                     result_.account, all_, above_, result_.tally));
  last_ = result_.account;
  all_ = result_.tally.all;
  above_ = result_.tally.above;
  ++stretch_;
}

results::Replicate Replica::result() const {
  results::Replicate given = result_;
  given.complete = stretch_ > stretches && given.stopped.empty();
  if (given.complete) return given;
  if (stretch_ == 0)
    given.at_settled = given.account;
  else if (given.account.time > last_.time)
    given.windows.push_back(window(given.account.time - what_->run.settle, last_, given.account,
                                   all_, above_, given.tally));
  return given;
}

void Replica::carry(Archive& archive) {
  results::Replicate& r = result_;
  r.tally.carry(archive);
  archive(r.windows)(r.account)(r.at_settled)(r.stopped)(r.at_stop)(r.cpu_seconds);
  archive(stretch_)(last_)(all_)(above_);
  engine_->carry(archive);
}

}  // namespace mahlwerk::campaign
