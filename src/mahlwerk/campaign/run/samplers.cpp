// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/run/samplers.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <utility>

#include "mahlwerk/cases/build.hpp"
#include "mahlwerk/cases/derived.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/results/quantities/motion_states.hpp"
#include "mahlwerk/scene/drawn_spheres.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

/// Samples the fields of the charge a few times in each window.
class ChargeSampler final : public Sampler {
 public:
  explicit ChargeSampler(results::Replicate& result) : charge_(&result.charge) {}
  void begin(double) override {}
  /// Plans as many samples as cost little compared with the work of a window.
  void begin_window(double begin, double length, std::optional<std::int64_t> work) override {
    constexpr std::int64_t most = 20;
    begin_ = begin;
    length_ = length;
    if (work) samples_ = static_cast<int>(std::clamp<std::int64_t>(*work, 1, most));
    taken_ = 0;
  }
  /// The golden ratio spreads the times over all phases of a periodic motion.
  double next() const override {
    if (length_ == 0 || taken_ == samples_) return never;
    constexpr double golden = 0.6180339887498949;  // (obs.6)
    const double jitter = std::fmod(golden * static_cast<double>(ever_ + 1), 1.0);
    return begin_ + length_ * (taken_ + jitter) / samples_;
  }
  void take(Moment& moment) override {
    for (; next() <= moment.now().time; ++taken_, ++ever_)
      charge_->sample(moment.time_of_balls(), moment.balls_inside(), length_ / samples_);
  }
  void serialize(Archive& archive) override { archive(begin_)(length_)(samples_)(taken_)(ever_); }

 private:
  observe::Charge* charge_;
  double begin_ = 0, length_ = 0;  // [s] of the window
  int samples_ = 4, taken_ = 0;    // in it
  std::int64_t ever_ = 0;
};

/// Follows the balls through each period of a shaken mill.
class MotionSampler final : public Sampler {
 public:
  MotionSampler(double period, results::Replicate& result)
      : interval_(period / observe::MotionStates::samples), result_(&result) {}
  void begin(double time) override { begin_ = time; }
  double next() const override {
    return begin_ + interval_ * static_cast<double>(result_->motion.taken() + 1);
  }
  void take(Moment& moment) override {
    const observe::CollisionSums& hits = result_->tally.above;
    while (next() <= moment.now().time)
      result_->motion.sample(moment.now().time, moment.balls_inside(),
                             {.lost = moment.now().lost(),
                              .hits = static_cast<double>(hits.count),
                              .energy = hits.energy_normal});
  }

 private:
  double interval_, begin_ = never;  // [s]
  results::Replicate* result_;
};

/// Calls a recorder of a part at its times.
class RecorderSampler final : public Sampler {
 public:
  explicit RecorderSampler(observe::Recorder& recorder) : recorder_(&recorder) {}
  void begin(double time) override { recorder_->begin(time); }
  double next() const override { return recorder_->next(); }
  void take(Moment& moment) override {
    if (recorder_->wants_balls())
      recorder_->take_balls(moment.now(), moment.time_of_balls(), moment.balls());
    else
      recorder_->take(moment.now());
  }

 private:
  observe::Recorder* recorder_;
};

/// Writes the frames that the case asks for.
class FrameSampler final : public Sampler {
 public:
  FrameSampler(const RunSetup& setup, std::unique_ptr<results::FrameFiles> files)
      : times_(*setup.mill_case), files_(std::move(files)) {
    files_->move_with(*setup.chamber.motion);
  }
  void begin(double time) override { times_.begin(time); }
  double next() const override { return times_.next(); }
  void take(Moment& moment) override {
    for (; times_.next() <= moment.now().time; times_.advance())
      files_->add(moment.time_of_balls(), moment.balls(), moment.engine().forces());
  }

 private:
  results::FrameTimes times_;
  std::unique_ptr<results::FrameFiles> files_;
};

/// Keeps the frames of the film that reports show.
class ReplaySampler final : public Sampler {
 public:
  ReplaySampler(const RunSetup& setup, results::Replicate& result)
      : setup_(&setup), replay_(&result.replay), shapes_(cases::body_shapes(*setup.mill_case)) {}
  void begin(double time) override {
    const cases::Case& mill_case = *setup_->mill_case;
    *replay_ = observe::Replay(
        setup_->chamber,
        cases::drawn_spheres(mill_case, cases::balls_by_set(mill_case.balls)).size(), time,
        mill_case.run.time, setup_->steps ? setup_->steps->frame_time() : 0);
  }
  double next() const override { return replay_->next_frame_time(); }
  /// Fragments of grains are not shown: a ball of the replay has one size.
  std::vector<scene::Ball> shown(const std::vector<scene::Ball>& balls) const {
    std::vector<scene::Ball> first = balls;
    const cases::Case& mill_case = *setup_->mill_case;
    if (!mill_case.bed_breakage) return first;
    first.resize(static_cast<std::size_t>(cases::balls_count(mill_case.balls)));
    const double grain = 0.5 * mill_case.balls.back().diameter;
    for (scene::Ball& b : first)
      if (b.kind == static_cast<std::int32_t>(mill_case.balls.size()) - 1 && b.radius < grain)
        b.outside = true;
    return first;
  }
  void take(Moment& moment) override {
    while (replay_->next_frame_time() <= moment.now().time)
      replay_->add(moment.time_of_balls(),
                   kinematics::clock(*setup_->chamber.motion, moment.time_of_balls()).time,
                   shapes_.empty() ? shown(moment.balls())
                                   : scene::drawn_spheres(moment.balls(), shapes_).spheres);
  }

 private:
  const RunSetup* setup_;
  observe::Replay* replay_;
  std::vector<scene::BodyShape> shapes_;  // by ball set; none: all are spheres
};

}  // namespace

const std::vector<scene::Ball>& Moment::balls() {
  if (!balls_) balls_ = engine_->balls();
  return *balls_;
}

const std::vector<scene::Ball>& Moment::balls_inside() {
  const std::vector<scene::Ball>& all = balls();
  if (std::ranges::none_of(all, &scene::Ball::outside)) return all;
  inside_.clear();
  std::ranges::copy_if(all, std::back_inserter(inside_),
                       [](const scene::Ball& ball) { return !ball.outside; });
  return inside_;
}

void Sampler::begin_window(double, double, std::optional<std::int64_t>) {}
void Sampler::serialize(Archive&) {}

Samplers samplers(const RunSetup& setup, std::unique_ptr<results::FrameFiles> frames,
                  results::Replicate& result) {
  Samplers made;
  for (const auto& recorder : result.recorders.all())
    made.push_back(std::make_unique<RecorderSampler>(*recorder));
  if (frames) made.push_back(std::make_unique<FrameSampler>(setup, std::move(frames)));
  made.push_back(std::make_unique<ChargeSampler>(result));
  const cases::Case& c = *setup.mill_case;
  if (results::has_motion_states(c))
    made.push_back(std::make_unique<MotionSampler>(cases::mill_period(c), result));
  return made;
}

std::unique_ptr<Sampler> replay_sampler(const RunSetup& setup, results::Replicate& result) {
  return std::make_unique<ReplaySampler>(setup, result);
}

}  // namespace mahlwerk::campaign
