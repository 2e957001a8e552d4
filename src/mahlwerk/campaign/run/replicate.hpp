// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <exception>
#include <memory>
#include <span>

#include "mahlwerk/campaign/run/replicate_engine.hpp"
#include "mahlwerk/campaign/run/samplers.hpp"
#include "mahlwerk/campaign/run/settling_test.hpp"
#include "mahlwerk/cases/settling.hpp"
#include "mahlwerk/lammps/launch.hpp"
#include "mahlwerk/results/files/frames.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::campaign {

/// One replicate of a case: settles, then counts collisions window by window. With run.settle =
/// "auto" it settles block by block, until there is no trend.
class ReplicateRun {
 public:
  /// `recorder` receives every counted record, `frames` the frames that the case requests. Once
  /// `*stop` is set, run_slice() returns early; throws Interrupted if `*stop` is set while balls
  /// are placed.
  ReplicateRun(std::shared_ptr<const RunSetup> setup, int index,
               std::unique_ptr<scene::Observer> recorder = nullptr,
               std::unique_ptr<results::FrameFiles> frames = nullptr, int threads = 1,
               const std::atomic<bool>* stop = nullptr, const lammps::Launch& launch = {});
  /// Of a case that has no other replicate. `mill_case` must outlive the run.
  ReplicateRun(const cases::Case& mill_case, int index,
               std::unique_ptr<scene::Observer> recorder = nullptr,
               std::unique_ptr<results::FrameFiles> frames = nullptr, int threads = 1,
               const std::atomic<bool>* stop = nullptr, const lammps::Launch& launch = {});

  ReplicateRun(const ReplicateRun&) = delete;
  ReplicateRun& operator=(const ReplicateRun&) = delete;

  /// Keeps frames for pictures, as the first replicate always does. Call it before the first slice
  /// and before a state is read. It changes no number.
  void record_replay();
  std::vector<scene::Ball> balls() const { return engine_->balls(); }
  /// [s] When counting begins, since the start of the run; no value while the mill settles.
  std::optional<double> counting_begins() const;
  /// Once `*stop` is set, run_slice() returns early.
  void stop_on(const std::atomic<bool>* stop) { engine_->stop_on(stop); }
  bool done() const;
  /// Advances by about a twentieth of a second of computing. The division of a run into slices
  /// changes no bit of its results.
  void run_slice();
  /// Advances unfinished replicates of one case, those that are furthest behind, with the same
  /// results as run_slice() of each. The soft engine computes few balls faster this way.
  static void run_slice_together(std::span<ReplicateRun* const> runs);
  const scene::EnergyBalance& energy_balance() const { return result_.energy_balance; }
  double& cpu_seconds() { return result_.cpu_seconds; }  ///< measured by the caller
  const observe::Replay& replay() const { return result_.replay; }
  /// Reason if physics stopped the run, else empty.
  const std::string& stop_reason() const { return result_.stop_reason; }
  /// The result so far.
  results::Replicate result() const;
  /// Writes the state to `archive`, or reads it from there (scene::Engine::serialize).
  void serialize(Archive& archive);

  /// Windows, which are the rows of the time series, in a run of any length. A run with `until` has
  /// 50 or more.
  static constexpr int max_windows = 200;

 private:
  class RecordingObserver;
  double window_end(int window) const;  // [s]
  bool finished() const;
  void add_partial_window(results::Replicate& given) const;
  double slice_end() const;  // [s]
  void end_slice(const std::exception_ptr& failure, double worked);
  void end_block();
  void begin_counting(double time);
  void begin_window(std::optional<std::int64_t> work);
  std::int64_t work_since(const scene::EnergyBalance& before) const;
  void take_samples();
  void end_window();

  std::shared_ptr<const RunSetup> setup_;
  const cases::Case* mill_case_;
  int index_;
  std::unique_ptr<scene::Observer> recorder_;
  results::Replicate result_;
  Samplers samplers_;             // write into result_
  cases::SettlingBlocks blocks_;  // of settling; of no length where its time is given
  SettlingTest settling_;
  std::int64_t settling_hits_ = 0;  // above the threshold
  double begin_ = 0;                // [s] of counting, once it has begun
  bool records_replay_ = false;
  double window_length_;    // [s]
  bool streams_;            // collision energies are kept for the powder sample
  bool converged_ = false;  // the requested precision is reached
  std::unique_ptr<scene::Engine> engine_;
  int window_ = 0;                      // 0: settling
  scene::EnergyBalance last_;           // at the start of the window
  observe::CollisionSums all_, above_;  // at the start of the window
  double slice_ = 1e-3;                 // [s] simulated time of a slice
};

/// Number of replicates that one thread should run together (ReplicateRun::run_slice_together), if
/// there are as many: several for few balls in the soft engine.
std::size_t replicates_together(const cases::Case& mill_case);

}  // namespace mahlwerk::campaign
