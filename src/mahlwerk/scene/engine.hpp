// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <optional>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/energy_balance.hpp"
#include "mahlwerk/scene/observer.hpp"
#include "mahlwerk/scene/wall_load.hpp"

namespace mahlwerk::scene {

/// Interface of both engines.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Advances to `time` [s] since the start and hands finished collisions to `observer`. Splitting
  /// a run into several calls does not change any bit of the result. Throws RunError where physics
  /// stops the run; all collisions until then have been handed over.
  virtual void advance(double time, Observer& observer) = 0;

  /// Once `*stop` is set, advance() returns early, between two events or steps;
  /// energy_balance().time is the time reached. Null: advance() never returns early.
  void stop_on(const std::atomic<bool>* stop) { stop_ = stop; }

  /// The energy balance at the time reached.
  virtual EnergyBalance energy_balance() const = 0;

  /// Counting begins: records of contacts that are open now leave out what these contacts have
  /// dissipated so far.
  virtual void begin_counting() {}

  /// The balls at the time reached, or at balls_time(), in the jar frame.
  virtual std::vector<Ball> balls() const = 0;

  /// [s] The time of balls(), for an engine that knows them at intervals only; else empty.
  virtual std::optional<double> balls_time() const { return std::nullopt; }

  /// Contact force on each ball [N] at the time reached, by ball number, in laboratory axes; empty
  /// if contacts are instantaneous.
  virtual std::vector<Vec3> forces() const { return {}; }

  /// Loads since the start, at the time reached: of the jar, then of each part. Empty if there are
  /// no parts, or from an engine that has none.
  virtual std::vector<WallLoad> wall_loads() const { return {}; }

  /// [s] CPU time so far of another program that computes for this engine, once that has ended.
  virtual double cpu_seconds_elsewhere() const { return 0; }

  /// How often that program went on from a file of its own, from where on its numbers are others.
  virtual int restarts() const { return 0; }

  /// Writes the present state to `archive`, or restores it from there. A restored engine made from
  /// the same case continues bit-identically.
  virtual void serialize(Archive& archive) = 0;

 protected:
  bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

 private:
  const std::atomic<bool>* stop_ = nullptr;
};

}  // namespace mahlwerk::scene
