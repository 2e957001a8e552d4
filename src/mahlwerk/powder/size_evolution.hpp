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

/// Size distribution of the powder over the milling time.
struct SizeEvolution {
  SizeGrid grid;
  std::vector<double> time;                 ///< [s] rising from 0; denser at the start
  std::vector<std::vector<double>> shares;  ///< mass shares of the classes, at each time

  std::vector<double> at(double time) const;  ///< shares at `time` [s], linearly interpolated
};

/// Output times [s]: 0, then twelve doublings up to `time` with 16 steps in each.
std::vector<double> output_times(double time);

/// Size evolution by the population balance. `known`: capture table of beds by size, if available.
SizeEvolution grind_by_balance(const Process& process, const StressSpectrum& stresses,
                               const SizeGrid& grid, const Feed& feed, double time,
                               const CaptureTable* known = nullptr);

/// A collision of the stream.
struct StreamHit {
  float energy = 0;      ///< [J] > 0
  std::int32_t nip = 0;  ///< index of the nip in the stress spectrum
};
/// Collisions in order of time over `span` [s], repeated periodically. Each stands for `weight`
/// collisions.
struct Stream {
  std::vector<StreamHit> hits;
  double weight = 1, span = 0;
};

/// Size evolution by a Monte Carlo simulation: hit by hit on a sample of `grains` grains; `start`:
/// seed of the random numbers. Hits without effect are skipped. If more than about ten million
/// remain, only every n-th hit is applied, and stands for n.
SizeEvolution grind_sample(const Process& process, const std::vector<Nip>& nips,
                           const Stream& stream, const SizeGrid& grid, const Feed& feed,
                           double time, int grains, std::uint64_t start);

}  // namespace mahlwerk::powder
