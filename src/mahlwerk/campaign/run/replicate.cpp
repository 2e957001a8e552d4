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
#include "mahlwerk/campaign/run/start.hpp"
#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/results/quantities/grinding.hpp"
#include "mahlwerk/results/quantities/replicate_setup.hpp"
#include "mahlwerk/results/quantities/series.hpp"
#include "mahlwerk/results/quantities/tables.hpp"

namespace mahlwerk::campaign {
namespace {

/// Differences between the start and the end of a window, as one row of the time series.
results::Window window_between(double end, const scene::EnergyBalance& a,
                               const scene::EnergyBalance& b, const observe::CollisionSums& all,
                               const observe::CollisionSums& above,
                               const observe::CollisionStatistics& after) {
  return {.time = end,
          .length = b.time - a.time,
          .collisions = static_cast<double>(after.all.count - all.count),
          .above = static_cast<double>(after.above.count - above.count),
          .energy_normal = after.all.energy_normal - all.energy_normal,
          .energy_contact_point = after.all.energy_contact_point - all.energy_contact_point,
          .lost = b.lost() - a.lost(),
          .wall_work = b.wall_work - a.wall_work,
          .flow = b.flow - a.flow,
          .contact_time = b.contact_time - a.contact_time,
          .kinetic = b.kinetic};
}

}  // namespace

/// Counts collisions, and passes them to the recorder if there is one.
class ReplicateRun::RecordingObserver final : public scene::Observer {
 public:
  explicit RecordingObserver(ReplicateRun& replica) : replica_(replica) {}
  void collisions(std::span<const scene::Collision> finished) override {
    if (replica_.window_ == 0) return count_hits(finished);
    results::Replicate& r = replica_.result_;
    r.tally.collisions(finished);
    for (const auto& recorder : r.recorders.all()) recorder->collisions(finished);
    if (replica_.records_replay_)
      r.replay.add_hits(finished, replica_.mill_case_->observe.threshold);
    if (replica_.streams_)
      r.stream.collisions(finished, r.tally.by_pair, results::stream_energy(*replica_.mill_case_));
    if (replica_.recorder_) replica_.recorder_->collisions(finished);
  }

  /// Recorders follow what is inside from the start of the run.
  void size_changes(std::span<const scene::SizeChange> changes) override {
    for (const auto& recorder : replica_.result_.recorders.all()) recorder->size_changes(changes);
  }
  void passages(std::span<const scene::Passage> passed) override {
    for (const auto& recorder : replica_.result_.recorders.all()) recorder->passages(passed);
  }

 private:
  void count_hits(std::span<const scene::Collision> finished) {
    replica_.settling_hits_ += std::ranges::count_if(finished, [&](const scene::Collision& c) {
      return c.approach >= replica_.mill_case_->observe.threshold;
    });
  }

  ReplicateRun& replica_;
};

std::size_t replicates_together(const cases::Case& mill_case) {
  const auto balls = static_cast<std::size_t>(cases::balls_count(mill_case.balls));
  const bool in_soft_engine = mill_case.run.engine == cases::EngineName::soft;
  // Contact and motion of all replicates.
  const bool same = cases::distinct_replicates(mill_case) == 1;
  return in_soft_engine && same && balls <= soft::side_by_side_limit ? 8 : 1;
}

namespace {

/// [s] With `until`, the first windows take one period of the mill, or 0.05 s if it has none.
double first_window_length(const cases::Case& mill_case) {
  if (!mill_case.run.until) return mill_case.run.time / ReplicateRun::max_windows;
  const double period = kinematics::period(*mill_case.mill.motion);
  return std::min(std::isfinite(period) ? period : 0.05,
                  mill_case.run.time / ReplicateRun::max_windows);
}

/// The motion of a mill that a motor turns differs from replicate to replicate.
std::shared_ptr<const RunSetup> with_own_drive(std::shared_ptr<const RunSetup> setup) {
  if (kinematics::drive_of(*setup->chamber.motion) == nullptr) return setup;
  auto own = std::make_shared<RunSetup>(*setup);
  own->chamber = cases::chamber(*own->mill_case);
  return own;
}

}  // namespace

ReplicateRun::ReplicateRun(const cases::Case& mill_case, int index,
                           std::unique_ptr<scene::Observer> recorder,
                           std::unique_ptr<results::FrameFiles> frames, int threads,
                           const std::atomic<bool>* stop, const lammps::Launch& launch)
    : ReplicateRun(std::make_shared<const RunSetup>(mill_case), index, std::move(recorder),
                   std::move(frames), threads, stop, launch) {}

ReplicateRun::ReplicateRun(std::shared_ptr<const RunSetup> setup, int index,
                           std::unique_ptr<scene::Observer> recorder,
                           std::unique_ptr<results::FrameFiles> frames, int threads,
                           const std::atomic<bool>* stop, const lammps::Launch& launch)
    : setup_(with_own_drive(std::move(setup))),
      mill_case_(setup_->mill_case),
      index_(index),
      recorder_(std::move(recorder)),
      result_(results::empty_replicate(*mill_case_)),
      samplers_(samplers(*setup_, std::move(frames), result_)),
      blocks_(cases::settles(*mill_case_) ? cases::settling_blocks(*mill_case_)
                                          : cases::SettlingBlocks{}),
      window_length_(first_window_length(*mill_case_)),
      streams_(mill_case_->grinding &&
               mill_case_->grinding->method != cases::Grinding::Method::balance),
      engine_(engine(*setup_, index, threads, stop, launch)),
      window_(cases::least_settling(*mill_case_) > 0 ? 0 : 1) {
  result_.charge = observe::Charge(setup_->chamber, result_.tally.wall_map.grid().radius,
                                   cases::sets_with_axis(*mill_case_));
  result_.motion = observe::MotionStates(setup_->chamber);
  last_ = result_.energy_balance = result_.at_settled = engine_->energy_balance();
  settling_.add(last_, 0);
  if (index == 0) record_replay();
  if (window_ == 1) {
    begin_counting(0);
    begin_window({});
  }
  // First slice of the soft engine: 1000 steps, below 0.1 s of computing for 1000 balls.
  if (mill_case_->run.engine == cases::EngineName::soft)
    slice_ = std::min(slice_, 1e3 * setup_->soft->rules.time_step);
}

void ReplicateRun::record_replay() {
  if (records_replay_) return;
  records_replay_ = true;
  samplers_.push_back(replay_sampler(*setup_, result_));
  if (window_ > 0) samplers_.back()->begin(begin_);
}

std::optional<double> ReplicateRun::counting_begins() const {
  return window_ > 0 ? std::optional(begin_) : std::nullopt;
}

/// Sets the time at which all that is recorded begins.
void ReplicateRun::begin_counting(double time) {
  begin_ = time;
  for (const auto& sampler : samplers_) sampler->begin(time);
}

/// Tells the samplers of the present window, and the work in the one before.
void ReplicateRun::begin_window(std::optional<std::int64_t> work) {
  for (const auto& sampler : samplers_)
    sampler->begin_window(begin_ + window_length_ * (window_ - 1), window_length_, work);
}

/// [s] While the mill settles, the end of the present block or of the given time.
double ReplicateRun::window_end(int window) const {
  if (window_ == 0)
    return blocks_.length > 0 ? blocks_.begin + blocks_.length * (settling_.blocks() + 1)
                              : cases::least_settling(*mill_case_);
  const bool last = !mill_case_->run.until && window == max_windows;
  return begin_ + (last ? mill_case_->run.time : window_length_ * window);
}

/// All windows are done, the requested precision is reached, or the time for it is over.
bool ReplicateRun::finished() const {
  if (!mill_case_->run.until) return window_ > max_windows;
  if (window_ == 0) return false;
  return converged_ || window_end(window_) > (begin_ + mill_case_->run.time) * (1 + 1e-12);
}

bool ReplicateRun::done() const {
  return finished() || !result_.stop_reason.empty();
}

/// Work since `before`, in units of what a sample of the charge costs.
std::int64_t ReplicateRun::work_since(const scene::EnergyBalance& before) const {
  constexpr std::int64_t steps = 512, collisions = 200;
  const scene::EnergyBalance& now = result_.energy_balance;
  if (cases::in_time_steps(mill_case_->run.engine))
    return (now.time_steps - before.time_steps) / steps;
  return (now.collisions - before.collisions) /
         (collisions * cases::balls_count(mill_case_->balls));
}

/// Takes the samples that are due.
void ReplicateRun::take_samples() {
  if (!result_.stop_reason.empty() || window_ == 0) return;
  Moment moment(*engine_, result_.energy_balance);
  for (const auto& sampler : samplers_)
    if (sampler->next() <= result_.energy_balance.time) sampler->take(moment);
}

/// [s] The time at which the next slice ends, unless another replicate ends it earlier.
double ReplicateRun::slice_end() const {
  double end = std::min(window_end(window_), result_.energy_balance.time + slice_);
  if (window_ == 0) return end;
  for (const auto& sampler : samplers_) end = std::min(end, sampler->next());
  return end;
}

void ReplicateRun::run_slice() {
  ReplicateRun* const alone = this;
  run_slice_together({&alone, 1});
}

void ReplicateRun::run_slice_together(std::span<ReplicateRun* const> runs) {
  const auto time_of = [](const ReplicateRun* run) { return run->result_.energy_balance.time; };
  const double now = time_of(*std::ranges::min_element(runs, {}, time_of));
  double end = std::numeric_limits<double>::infinity();
  std::vector<ReplicateRun*> behind;
  for (ReplicateRun* run : runs) {
    end = std::min(end, time_of(run) > now ? time_of(run) : run->slice_end());
    if (time_of(run) == now) behind.push_back(run);
  }
  std::vector<RecordingObserver> recording;
  std::vector<scene::Engine*> engines;
  std::vector<scene::Observer*> observers;
  for (ReplicateRun* run : behind) recording.emplace_back(*run), engines.push_back(&*run->engine_);
  for (RecordingObserver& observer : recording) observers.push_back(&observer);
  const auto began = std::chrono::steady_clock::now();
  const auto failures = soft::advance_together(engines, end, observers);
  const double worked =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  for (std::size_t k = 0; k < behind.size(); ++k) behind[k]->end_slice(failures[k], worked);
}

/// Takes samples and ends the window, if they are due; adapts the slice to the time `worked` [s].
void ReplicateRun::end_slice(const std::exception_ptr& failure, double worked) {
  try {
    if (failure) std::rethrow_exception(failure);
  } catch (const RunError& e) {
    result_.stop_reason = fmt::format("{}. State of the balls at that time: {}.csv", e.what(),
                                      results::stopped_name(index_));
    result_.balls_at_stop = engine_->balls();
  }
  result_.energy_balance = engine_->energy_balance();
  const double end = window_end(window_);
  take_samples();
  slice_ *= worked < 0.025 ? 2 : worked > 0.1 ? 0.25 : 1;
  slice_ =
      std::min(std::max(slice_, 1e-15), cases::least_settling(*mill_case_) + mill_case_->run.time);
  if (result_.energy_balance.time >= end || !result_.stop_reason.empty()) end_window();
}

/// Ends a block of settling, or settling that a run error ended. Counting begins once there is no
/// trend, or after the most blocks.
void ReplicateRun::end_block() {
  const double end = window_end(0);
  settling_.add(result_.energy_balance, settling_hits_);
  result_.settled = settling_.settled();
  if (!result_.settled && settling_.blocks() < blocks_.most && result_.stop_reason.empty()) return;
  engine_->begin_counting();
  result_.loads_at_settled = engine_->wall_loads();
  result_.at_settled = last_ = result_.energy_balance = engine_->energy_balance();
  window_ = 1;
  begin_counting(end);
  begin_window({});
}

void ReplicateRun::end_window() {
  if (window_ == 0 && blocks_.length > 0) return end_block();
  if (window_ == 0) {
    const double end = window_end(0);
    engine_->begin_counting();
    result_.loads_at_settled = engine_->wall_loads();
    result_.at_settled = result_.energy_balance = engine_->energy_balance();
    begin_counting(end);
  } else {
    result_.windows.push_back(window_between(result_.energy_balance.time - begin_, last_,
                                             result_.energy_balance, all_, above_, result_.tally));
  }
  const std::int64_t work = work_since(last_);
  last_ = result_.energy_balance;
  all_ = result_.tally.all;
  above_ = result_.tally.above;
  ++window_;
  if (mill_case_->run.until && std::ssize(result_.windows) == max_windows) {
    result_.windows = results::merge_window_pairs(result_.windows);
    window_length_ *= 2;
    window_ = max_windows / 2 + 1;
  }
  begin_window(work);
  if (!mill_case_->run.until || !result_.stop_reason.empty()) return;
  constexpr int fewest = 50, between = 10;
  if (std::ssize(result_.windows) < fewest || window_ % between != 1) return;
  const observe::Estimate known = observe::time_series_estimate(
      results::series(result_.windows, mill_case_->run.until->quantity));
  converged_ = known.mean != 0 &&  // nothing has happened yet
               known.ci95 <= mill_case_->run.until->within * std::abs(known.mean);
}

results::Replicate ReplicateRun::result() const {
  results::Replicate given = result_;
  given.loads = engine_->wall_loads();
  given.complete = finished() && given.stop_reason.empty();
  given.precision_reached = !mill_case_->run.until || converged_;
  if (!given.complete) add_partial_window(given);
  if (given.complete && mill_case_->observe.final_state)
    given.balls_at_end = seen_from_carrier(
        *mill_case_, engine_->balls(), engine_->balls_time().value_or(given.energy_balance.time));
  given.cpu_seconds += engine_->cpu_seconds_elsewhere();
  given.restarts = engine_->restarts();
  results::grind(*mill_case_, given, index_);
  return given;
}

/// Adds the window that did not end.
void ReplicateRun::add_partial_window(results::Replicate& given) const {
  if (window_ == 0)
    given.at_settled = given.energy_balance, given.loads_at_settled = given.loads;
  else if (given.energy_balance.time > last_.time)
    given.windows.push_back(window_between(given.energy_balance.time - begin_, last_,
                                           given.energy_balance, all_, above_, given.tally));
}

void ReplicateRun::serialize(Archive& archive) {
  results::Replicate& r = result_;
  archive(window_)(begin_)(settling_hits_)(r.settled);
  settling_.serialize(archive);
  if (archive.reading() && window_ > 0) begin_counting(begin_);
  r.tally.serialize(archive);
  r.charge.serialize(archive);
  r.motion.serialize(archive);
  r.replay.serialize(archive);
  r.stream.serialize(archive);
  for (const auto& recorder : r.recorders.all()) recorder->serialize(archive);
  archive(r.windows)(r.energy_balance)(r.at_settled)(r.stop_reason)(r.balls_at_stop)(r.cpu_seconds);
  if (!setup_->chamber.parts.empty()) archive(r.loads_at_settled);
  archive(last_)(all_)(above_)(window_length_)(converged_);
  for (const auto& sampler : samplers_) sampler->serialize(archive);
  engine_->serialize(archive);
}

}  // namespace mahlwerk::campaign
