// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/campaign/run/run_setup.hpp"
#include "mahlwerk/results/files/frames.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/scene/engine.hpp"

// What a replicate records at times of its own, besides collisions.
namespace mahlwerk::campaign {

/// A time of a run at which something is recorded. The balls are read once, when they are needed.
class Moment {
 public:
  Moment(const scene::Engine& engine, const scene::EnergyBalance& now)
      : engine_(&engine), now_(&now) {}
  const scene::EnergyBalance& now() const { return *now_; }
  const scene::Engine& engine() const { return *engine_; }
  const std::vector<scene::Ball>& balls();
  /// Without those that have left the jar.
  const std::vector<scene::Ball>& balls_inside();
  /// [s] of the balls: an engine may know them at an earlier time only.
  double time_of_balls() const { return engine_->balls_time().value_or(now_->time); }

 private:
  const scene::Engine* engine_;
  const scene::EnergyBalance* now_;
  std::optional<std::vector<scene::Ball>> balls_;
  std::vector<scene::Ball> inside_;
};

/// Says when it wants to record, and records then.
class Sampler {
 public:
  virtual ~Sampler() = default;
  /// Counting begins at `time` [s]; also called when a state is read.
  virtual void begin(double time) = 0;
  /// A window of the counted time begins at `begin` [s]. `work`: of the balls in the one before, if
  /// it is known, in units of the cost of a sample.
  virtual void begin_window(double begin, double length, std::optional<std::int64_t> work);
  /// [s] The next time to record; infinite where there is none.
  virtual double next() const = 0;
  /// Records all that is due; called once `moment` is not before next().
  virtual void take(Moment& moment) = 0;
  /// What the result does not hold.
  virtual void serialize(Archive& archive);
};
using Samplers = std::vector<std::unique_ptr<Sampler>>;

/// The samplers of a case: recorders of parts, frames, charge. They write into `result`.
Samplers samplers(const RunSetup& setup, std::unique_ptr<results::FrameFiles> frames,
                  results::Replicate& result);
/// The sampler of the film that reports show.
std::unique_ptr<Sampler> replay_sampler(const RunSetup& setup, results::Replicate& result);

}  // namespace mahlwerk::campaign
