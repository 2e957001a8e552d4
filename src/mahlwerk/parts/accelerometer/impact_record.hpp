// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/base/vec3.hpp"
#include "mahlwerk/observe/recorder.hpp"

namespace mahlwerk::parts::accelerometer {

/// Record of the force of impacts on the jar along one direction, in equal intervals of time. The
/// impulse of a contact is spread evenly over its duration.
class ImpactRecord : public observe::Recorder {
 public:
  /// `axis`: unit vector in the jar's own axes. The record has `count` intervals of `step` [s] from
  /// `begin` [s] since the start of the run.
  ImpactRecord(const Vec3& axis, double begin, double step, std::size_t count)
      : axis_(axis), begin_(begin), step_(step), impulses_(count) {}

  std::unique_ptr<Recorder> copy() const override { return std::make_unique<ImpactRecord>(*this); }
  void collisions(std::span<const scene::Collision> finished) override;
  void begin(double time) override { begin_ = time; }  ///< [s] where the record begins
  double step() const { return step_; }                ///< [s]
  double begin() const { return begin_; }              ///< [s]
  const Vec3& axis() const { return axis_; }
  /// [N s] Impulse of the balls on the jar along the axis, by interval.
  const std::vector<double>& impulses() const { return impulses_; }
  /// Throws RunError for a saved record of another length.
  void serialize(Archive& archive) override;

 private:
  void add(double from, double to, double impulse);

  Vec3 axis_;
  double begin_, step_;
  std::vector<double> impulses_;
};

/// Response of a sensor to the signal `input`, constant over each `step` [s] > 0: a low-pass filter
/// of second order with Butterworth damping and `bandwidth` [Hz] > 0, which shows `start` steadily
/// before. Exact at the end of each interval (sns.6).
std::vector<double> low_pass(const std::vector<double>& input, double step, double bandwidth,
                             double start);

}  // namespace mahlwerk::parts::accelerometer
