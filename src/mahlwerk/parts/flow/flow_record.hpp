// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "mahlwerk/observe/recorder.hpp"

namespace mahlwerk::parts::flow {

/// Balls of a set, or of all.
struct Amount {
  double count = 0, mass = 0;  ///< [1], [kg]

  void add(double more, double of_mass) { count += more, mass += more * of_mass; }
};

/// What has passed since counting began, and what is inside.
struct Holdup {
  Amount left, entered, inside;
};

/// A ball that entered since counting began, and the time that it has been inside [s]; `left`:
/// until it left, else until the end.
struct Tracer {
  double time = 0;
  bool left = false;
};

/// Follows every ball that leaves and enters.
class FlowRecord final : public observe::Recorder {
 public:
  /// `inside` has the balls of each set at the start of the run.
  FlowRecord(std::vector<Amount> inside, std::size_t balls, double interval);

  std::unique_ptr<observe::Recorder> copy() const override {
    return std::make_unique<FlowRecord>(*this);
  }
  void begin(double time) override;
  double next() const override { return begin_ + interval_ * static_cast<double>(times_.size()); }
  void passages(std::span<const scene::Passage> passed) override;
  void take(const scene::EnergyBalance& now) override;
  void serialize(Archive& archive) override;

  std::size_t sets() const { return sets_.size(); }
  double begin() const { return begin_; }                      ///< [s] of counting
  const std::vector<double>& times() const { return times_; }  ///< [s] of the samples
  const Holdup& sample(std::size_t time, std::size_t set) const {
    return samples_[time * sets_.size() + set];
  }
  Holdup all() const;  ///< of all sets together, now
  /// Mean of what was inside from the begin of counting to `end` [s] (flo.3).
  Amount mean_inside(double end) const;
  /// The balls that entered since counting began, at `end` [s].
  std::vector<Tracer> tracers(double end) const;

 private:
  void sum_until(double time);

  double interval_;
  double begin_ = std::numeric_limits<double>::infinity();
  std::vector<Holdup> sets_;
  std::vector<double> entered_at_;  // [s] of each ball; < 0: not since counting began
  std::vector<double> stayed_;      // [s] of balls that left
  double summed_until_ = 0;         // [s]
  Amount sum_;                      // [s], [kg s] of what was inside, over time
  std::vector<double> times_;
  std::vector<Holdup> samples_;  // of each set, time by time
};

}  // namespace mahlwerk::parts::flow
