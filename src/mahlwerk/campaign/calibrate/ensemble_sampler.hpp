// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

namespace mahlwerk::campaign {

/// A sample of a density, and what its quality is.
struct DensitySample {
  std::vector<std::vector<double>> points;
  double acceptance = 0;  ///< [1] share of the proposed moves that were made
  double shrinkage = 1;   ///< [1] largest potential scale reduction of a coordinate; 1: converged
};

struct SamplerSettings {
  int walkers = 64;     ///< even, at least twice the number of coordinates
  int burn_in = 300;    ///< moves of each walker before its points count
  int moves = 600;      ///< moves of each walker that count
  int keep_every = 10;  ///< of these moves
  std::uint64_t seed = 1;
};

/// Samples a density in the unit cube by the affine-invariant ensemble of Goodman and Weare (2010):
/// stretch moves (cal.5). `log_density` is known but for a constant; -infinity or NaN where the
/// density is zero. Walkers begin at the best of `starts` (at least one with a density).
/// Deterministic.
DensitySample sample_density(const std::function<double(const std::vector<double>&)>& log_density,
                             const std::vector<std::vector<double>>& starts,
                             const SamplerSettings& settings);

}  // namespace mahlwerk::campaign
