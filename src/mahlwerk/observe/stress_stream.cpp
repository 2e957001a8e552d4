// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/observe/stress_stream.hpp"

namespace mahlwerk::observe {

void StressStream::collisions(std::span<const scene::Collision> finished,
                              const StatisticsByPair& pairs, Energy energy) {
  for (const scene::Collision& c : finished) {
    if (received_++ % stride_ != 0) continue;
    const double value = energy == Energy::normal          ? c.energy_normal()
                         : energy == Energy::contact_point ? c.energy_contact_point()
                                                           : c.lost();
    hits_.push_back({static_cast<float>(value), pairs.pair_of(c)});
    if (hits_.size() < most) continue;
    for (std::size_t i = 0; 2 * i < hits_.size(); ++i) hits_[i] = hits_[2 * i];
    hits_.resize(most / 2);
    stride_ *= 2;
  }
}

}  // namespace mahlwerk::observe
