// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
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

/// The balls that wait to be fed, since counting began.
struct Queue {
  double mean = 0;       ///< [1] number of them, over time
  double busy_time = 0;  ///< [s] in which one waited or more
};

/// Follows every ball that leaves and enters.
class FlowRecord final : public observe::Recorder {
 public:
  struct Setup {
    std::vector<Amount> inside;  ///< balls of each set that are in the jar at the start of the run
    std::size_t balls = 0;       ///< of all sets
    double interval = 0;         ///< [s]
    double fresh = 0;            ///< balls that are outside at the start, waiting to be fed
    bool returns = true;         ///< what has left waits to be fed again
  };
  explicit FlowRecord(const Setup& setup);

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
  /// The balls that waited, from the begin of counting to `end` [s].
  Queue queue(double end) const;
  /// [s] since the start of the run: when the last ball that can be fed entered; none: some wait,
  /// or what has left is fed again.
  std::optional<double> exhausted() const {
    return returns_ || fresh_ == 0 || waiting_ > 0 ? std::nullopt : std::optional(last_entry_);
  }
  /// The balls that entered since counting began, at `end` [s].
  std::vector<Tracer> tracers(double end) const;

 private:
  void sum_until(double time);

  double interval_, fresh_;
  bool returns_;
  double begin_ = std::numeric_limits<double>::infinity();
  std::vector<Holdup> sets_;
  std::vector<double> entered_at_;  // [s] of each ball; < 0: not since counting began
  std::vector<double> stayed_;      // [s] of balls that left
  double summed_until_ = 0;         // [s]
  Amount sum_;                      // [s], [kg s] of what was inside, over time
  double waiting_;                  // balls that can be fed
  double waited_ = 0, busy_ = 0;    // [s] of them over time, and with one or more
  double last_entry_ = 0;           // [s]
  std::vector<double> times_;
  std::vector<Holdup> samples_;  // of each set, time by time
};

}  // namespace mahlwerk::parts::flow
