// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <vector>

#include "mahlwerk/powder/feed.hpp"
#include "mahlwerk/powder/rates.hpp"
#include "mahlwerk/powder/sizes.hpp"
#include "mahlwerk/powder/stress.hpp"

namespace mahlwerk::powder {

struct Process;

/// How fine the powder is over the time of milling.
struct SizeEvolution {
  SizeGrid grid;
  std::vector<double> time;                 ///< [s] from 0 on, rising; closer at the start
  std::vector<std::vector<double>> shares;  ///< of the mass in each class, at each time

  std::vector<double> at(double time) const;  ///< shares then, between two times in proportion
};

/// Times [s] at which it is told: 0, then twelve doublings up to `time`, 16 steps in each.
std::vector<double> output_times(double time);

/// By the population balance. `known`: its beds by size, where they are at hand.
SizeEvolution grind_by_balance(const Process& process, const StressSpectrum& stresses,
                               const SizeGrid& grid, const Feed& feed, double time,
                               const CaptureTable* known = nullptr);

/// A collision of the stream.
struct StreamHit {
  float energy = 0;      ///< [J] > 0
  std::int32_t nip = 0;  ///< of the spectrum's
};
/// Collisions in the order of time, each for `weight` of its like, over `span` [s]; then again.
struct Stream {
  std::vector<StreamHit> hits;
  double weight = 1, span = 0;
};

/// Hit by hit on a sample of so many grains; `start` of its random numbers. Hits that can do
/// nothing are left out; where the others are more than some ten million, each stands for several.
SizeEvolution grind_sample(const Process& process, const std::vector<Nip>& nips,
                           const Stream& stream, const SizeGrid& grid, const Feed& feed,
                           double time, int grains, std::uint64_t start);

}  // namespace mahlwerk::powder
