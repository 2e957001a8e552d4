// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <atomic>
#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/scene/balls.hpp"
#include "mahlwerk/scene/energy_balance.hpp"
#include "mahlwerk/scene/observer.hpp"

namespace mahlwerk::scene {

/// Both engines, seen from outside.
class Engine {
 public:
  virtual ~Engine() = default;

  /// Goes on to `time` [s] since the start, handing finished collisions to `observer`. How a run is
  /// cut into calls does not change it by a bit. Throws RunError where physics stops it, with all
  /// collisions up to then handed over.
  virtual void advance(double time, Observer& observer) = 0;

  /// Once `*stop` is set `advance` ends early, between two events or steps; energy_balance().time
  /// says how far it came. Null: it never does.
  void stop_on(const std::atomic<bool>* stop) { stop_ = stop; }

  /// The energy account at the time reached.
  virtual EnergyBalance energy_balance() const = 0;

  /// The balls at the time reached, in the jar frame.
  virtual std::vector<Ball> balls() const = 0;

  /// [N] of contacts on each ball at the time reached, by ball number, in axes of the laboratory;
  /// empty where contacts are instantaneous.
  virtual std::vector<Vec3> forces() const { return {}; }

  /// Writes the state reached to `archive`, or takes it from there; an engine made from the same
  /// case then goes on as if nothing had happened, to the bit.
  virtual void serialize(Archive& archive) = 0;

 protected:
  bool stopped() const { return stop_ != nullptr && stop_->load(std::memory_order_relaxed); }

 private:
  const std::atomic<bool>* stop_ = nullptr;
};

}  // namespace mahlwerk::scene
