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
class Replica {
 public:
  /// `keeper` gets every counted record, `frames` the frames that the case asks for. Once `*stop`
  /// is set go_on() returns early; throws Interrupted if that is so while balls are placed.
  Replica(const cases::Case& what, int index, std::unique_ptr<scene::Observer> keeper = nullptr,
          std::unique_ptr<results::FrameFiles> frames = nullptr, int threads = 1,
          const std::atomic<bool>* stop = nullptr);

  /// Once `*stop` is set go_on() returns early.
  void stop_on(const std::atomic<bool>* stop) { engine_->stop_on(stop); }
  bool done() const;
  /// Goes on for about a twentieth of a second of work. How a run is cut changes no bit of it.
  void go_on();
  const scene::Account& account() const { return result_.account; }
  double& cpu_seconds() { return result_.cpu_seconds; }  ///< for whoever measures it
  /// What it has given so far.
  results::Replicate result() const;
  /// Writes the state to `archive`, or takes it from there (scene::Engine::carry).
  void carry(Archive& archive);

  /// Rows of the time series, however long the run is; a run that waits for certainty has half as
  /// many, or more.
  static constexpr int stretches = 200;

 private:
  class Ears;
  double end_of(int stretch) const;  // [s]
  bool over() const;
  void end_early(results::Replicate& given) const;
  void advance(double time);
  void look();
  void end_stretch();
  void plan_looks(const scene::Account& before, const scene::Account& now);
  double next_look() const;  // [s]

  const cases::Case* what_;
  int index_;
  std::unique_ptr<scene::Observer> keeper_;
  std::unique_ptr<results::FrameFiles> frames_;
  results::FrameTimes frame_times_;
  results::Replicate result_;
  double window_;        // [s] length of a stretch
  bool streams_;         // energies are kept for a sample of the powder
  bool enough_ = false;  // it is as sure as was asked for
  int looks_ = 4;        // at the charge in this stretch
  int looked_ = 0;       // of them
  std::int64_t looked_ever_ = 0;
  std::int64_t balls_ = 0;
  std::unique_ptr<scene::Engine> engine_;
  int stretch_ = 0;            // 0: settling
  scene::Account last_;        // when the stretch began
  observe::Sums all_, above_;  // then
  double portion_ = 1e-3;      // [s] simulated
};

/// The engine of one replicate at its start: run.engine, where "auto" counts as "event".
/// `threads` may share its work; the result does not depend on them. Heeds `stop`
/// (scene::Engine::stop_on) from the placing of the balls on, where it throws Interrupted.
std::unique_ptr<scene::Engine> engine(const cases::Case& what, int index, int threads = 1,
                                      const std::atomic<bool>* stop = nullptr);

}  // namespace mahlwerk::campaign
