// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "mahlwerk/observe/recorder.hpp"

namespace mahlwerk::parts::bed_breakage {

/// The sizes of a powder at one time.
struct SizeSample {
  double time = 0;           ///< [s] since counting began
  std::int64_t broken = 0;   ///< grains since then
  std::vector<double> mass;  ///< [kg] of each size class

  void serialize(Archive& archive) { archive(time)(broken)(mass); }
};

/// Follows the sizes of a powder whose grains break.
class SizeRecord final : public observe::Recorder {
 public:
  /// `mass` [kg] of each size class at the start; `interval` [s] between two samples.
  SizeRecord(std::vector<double> mass, double interval)
      : interval_(interval), now_{0, 0, std::move(mass)} {}

  std::unique_ptr<observe::Recorder> copy() const override {
    return std::make_unique<SizeRecord>(*this);
  }
  void begin(double time) override { begin_ = time; }
  double next() const override { return begin_ + interval_ * static_cast<double>(samples_.size()); }
  void size_changes(std::span<const scene::SizeChange> changes) override;
  void take(const scene::EnergyBalance& now) override;
  void serialize(Archive& archive) override;

  const std::vector<SizeSample>& samples() const { return samples_; }
  const SizeSample& now() const { return now_; }

 private:
  double interval_, begin_ = std::numeric_limits<double>::infinity();
  SizeSample now_;
  std::vector<SizeSample> samples_;
};

}  // namespace mahlwerk::parts::bed_breakage
