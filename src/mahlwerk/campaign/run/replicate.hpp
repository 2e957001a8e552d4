// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <memory>

#include "mahlwerk/cases/read.hpp"
#include "mahlwerk/results/files/frames.hpp"
#include "mahlwerk/results/outcome.hpp"
#include "mahlwerk/scene/engine.hpp"

namespace mahlwerk::campaign {

/// One replicate of a case in the making: settles, then counts, stretch by stretch.
class ReplicateRun {
 public:
  /// `recorder` gets every counted record, `frames` the frames that the case asks for. Once `*stop`
  /// is set run_slice() returns early; throws Interrupted if that is so while balls are placed.
  ReplicateRun(const cases::Case& what, int index,
               std::unique_ptr<scene::Observer> recorder = nullptr,
               std::unique_ptr<results::FrameFiles> frames = nullptr, int threads = 1,
               const std::atomic<bool>* stop = nullptr);

  /// Once `*stop` is set run_slice() returns early.
  void stop_on(const std::atomic<bool>* stop) { engine_->stop_on(stop); }
  bool done() const;
  /// Goes on for about a twentieth of a second of work. How a run is cut changes no bit of it.
  void run_slice();
  const scene::EnergyBalance& energy_balance() const { return result_.energy_balance; }
  double& cpu_seconds() { return result_.cpu_seconds; }  ///< for whoever measures it
  /// What it has given so far.
  results::Replicate result() const;
  /// Writes the state to `archive`, or takes it from there (scene::Engine::serialize).
  void serialize(Archive& archive);

  /// Rows of the time series, however long the run is; a run that waits for certainty has half as
  /// many, or more.
  static constexpr int max_windows = 200;

 private:
  class RecordingObserver;
  double window_end(int window) const;  // [s]
  bool finished() const;
  void add_partial_window(results::Replicate& given) const;
  void advance(double time);
  void take_samples();
  void end_window();
  void plan_charge_samples(const scene::EnergyBalance& before, const scene::EnergyBalance& now);
  double next_charge_sample() const;  // [s]

  const cases::Case* what_;
  int index_;
  std::unique_ptr<scene::Observer> recorder_;
  std::unique_ptr<results::FrameFiles> frames_;
  results::FrameTimes frame_times_;
  results::Replicate result_;
  double window_length_;          // [s] length of a stretch
  bool streams_;                  // energies are kept for a sample of the powder
  bool converged_ = false;        // it is as sure as was asked for
  int charge_samples_ = 4;        // at the charge in this stretch
  int charge_samples_taken_ = 0;  // of them
  std::int64_t charge_samples_ever_ = 0;
  std::int64_t balls_ = 0;
  std::unique_ptr<scene::Engine> engine_;
  int window_ = 0;                      // 0: settling
  scene::EnergyBalance last_;           // when the stretch began
  observe::CollisionSums all_, above_;  // then
  double slice_ = 1e-3;                 // [s] simulated
};

/// The engine of one replicate at its start: run.engine, where "auto" counts as "event".
/// `threads` may share its work; the result does not depend on them. Heeds `stop`
/// (scene::Engine::stop_on) from the placing of the balls on, where it throws Interrupted.
std::unique_ptr<scene::Engine> engine(const cases::Case& what, int index, int threads = 1,
                                      const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::campaign
