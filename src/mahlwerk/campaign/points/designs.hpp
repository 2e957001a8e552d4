// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

// Designs: the points of a campaign in the ranges of its keys (docs/theory/sensitivity.md).
namespace mahlwerk::campaign {

/// By row and key: position in the key's range, 0 to 1. The same input gives the same rows.
using DesignMatrix = std::vector<std::vector<double>>;

/// Latin hypercube: each key's range is divided into `samples` equal parts with one point in each
/// (McKay 1979).
DesignMatrix latin_hypercube(std::size_t keys, std::size_t samples, std::uint64_t seed);

/// Sobol' sequence (1967) with the direction numbers of Joe and Kuo (2008), without its first
/// point, the corner. Evenly spread for any `samples`, most evenly for one less than a power of 2.
/// More samples begin with the same rows. At most 3667 keys, else std::invalid_argument.
DesignMatrix sobol_points(std::size_t keys, std::size_t samples);

/// First a row with all keys at `base`, then two for each key: only this key at 0, then at 1. A
/// base of NaN stands for the value in the case.
DesignMatrix one_at_a_time_design(std::size_t keys, double base = 0.5);

/// `trajectories` trajectories of keys + 1 rows each through a grid of four levels. From row to row
/// one key moves, by two thirds of its range (Morris 1991, sen.1). More trajectories begin with the
/// same rows.
DesignMatrix morris_design(std::size_t keys, std::size_t trajectories, std::uint64_t seed);

/// `base` groups of keys + 2 rows each: a, then a with one key after the other taken from b, then b
/// (Saltelli 2010, sen.6). a and b are the halves of a row of a Sobol' sequence with a random
/// digital shift, which keeps the rows evenly spread, most evenly for a `base` that is a power of
/// 2. More groups begin with the same rows. At most 1833 keys, else std::invalid_argument.
DesignMatrix saltelli_design(std::size_t keys, std::size_t base, std::uint64_t seed = 1);

}  // namespace mahlwerk::campaign
