// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

#include "mahlwerk/base/archive.hpp"
#include "mahlwerk/observe/histogram.hpp"
#include "mahlwerk/observe/recorder.hpp"

namespace mahlwerk::parts::microphone {

/// Counts hits as an acoustic sensor does: hits that follow each other within the definition time
/// are one (sns.3), with the largest of their normal energies. Uses fixed memory.
class HitCounter : public observe::Recorder {
 public:
  /// Hears collisions with a normal energy of at least `threshold` [J]; those between balls only if
  /// `between_balls`. `definition_time` [s] >= 0.
  HitCounter(double threshold, double definition_time, bool between_balls)
      : threshold_(threshold), definition_time_(definition_time), between_balls_(between_balls) {}

  std::unique_ptr<Recorder> copy() const override { return std::make_unique<HitCounter>(*this); }
  void collisions(std::span<const scene::Collision> finished) override;
  std::int64_t impacts() const { return impacts_; }  ///< loud enough, also those heard as one
  observe::LogHistogram heard() const;  ///< hits by energy [J], the present one included
  void serialize(Archive& archive) override;

 private:
  void hear(double time, double energy);

  double threshold_, definition_time_;
  bool between_balls_;
  std::int64_t impacts_ = 0;
  observe::LogHistogram ended_;
  bool ringing_ = false;           // a hit is present
  double last_ = 0, largest_ = 0;  // [s] its last collision, [J] its energy
};

}  // namespace mahlwerk::parts::microphone
