// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/parts/microphone/hit_counter.hpp"

#include <algorithm>

namespace mahlwerk::parts::microphone {

void HitCounter::collisions(std::span<const scene::Collision> finished) {
  for (const scene::Collision& c : finished) {
    if (c.other >= 0 && !between_balls_) continue;
    const double energy = c.energy_normal();
    if (energy >= threshold_) hear(c.time + c.duration, energy);  // they come in order of their end
  }
}

void HitCounter::hear(double time, double energy) {
  ++impacts_;
  if (ringing_ && time - last_ < definition_time_) {
    largest_ = std::max(largest_, energy);
  } else {
    if (ringing_) ended_.add(largest_);
    largest_ = energy;
  }
  ringing_ = true;
  last_ = time;
}

observe::LogHistogram HitCounter::heard() const {
  observe::LogHistogram all = ended_;
  if (ringing_) all.add(largest_);
  return all;
}

void HitCounter::serialize(Archive& archive) {
  ended_.serialize(archive);
  archive(impacts_)(ringing_)(last_)(largest_);
}

}  // namespace mahlwerk::parts::microphone
