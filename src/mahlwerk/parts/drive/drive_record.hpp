// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "mahlwerk/observe/recorder.hpp"

namespace mahlwerk::parts::drive {

/// The state of a drive.
struct DriveSample {
  double time = 0;                       ///< [s] since counting began
  double speed = 0;                      ///< [rad/s] of the mill
  double angle = 0;                      ///< [rad] turned since the start of the run
  double motor_work = 0, wall_work = 0;  ///< [J] since the start of the run
};

/// Records a drive at equal intervals.
class DriveRecord final : public observe::Recorder {
 public:
  explicit DriveRecord(double interval) : interval_(interval) {}

  std::unique_ptr<observe::Recorder> copy() const override {
    return std::make_unique<DriveRecord>(*this);
  }
  void begin(double time) override { begin_ = time; }
  double next() const override { return begin_ + interval_ * static_cast<double>(taken_); }
  void take(const scene::EnergyBalance& now) override {
    samples_.push_back(
        {now.time - begin_, now.mill_speed, now.mill_angle, now.motor_work, now.wall_work});
    while (next() <= now.time) ++taken_;
  }
  void serialize(Archive& archive) override { archive(begin_)(samples_)(taken_); }

  const std::vector<DriveSample>& samples() const { return samples_; }

 private:
  double interval_, begin_ = std::numeric_limits<double>::infinity();  // [s]
  std::vector<DriveSample> samples_;
  std::int64_t taken_ = 0;
};

}  // namespace mahlwerk::parts::drive
