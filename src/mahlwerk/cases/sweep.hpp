// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

// Sections of a case for many runs: the keys that vary, and the target of a search.
namespace mahlwerk::cases {

/// A key of the case that varies, and its values.
struct SweptKey {
  std::string key;                  ///< "mill.speed", "balls.2.diameter"
  std::vector<std::string> values;  ///< as text; the two ends of a range
  bool range = false;               ///< a continuous range between two ends
  std::int64_t steps = 0;           ///< of a range: number of values on a grid; 0: not given
  bool logarithmic = false;         ///< of a range: logarithmic spacing
  bool operator==(const SweptKey&) const = default;
};

/// Experimental design: the choice of the points of a campaign (docs/theory/campaigns.md).
enum class Design {
  grid,             ///< full factorial: each combination of values
  latin_hypercube,  ///< each range divided into as many intervals as points, one point in each
  sobol,            ///< low-discrepancy Sobol' sequence (Sobol' 1967)
  one_at_a_time,    ///< the case itself, then each key alone at its ends
  morris,           ///< elementary effects along random trajectories (Morris 1991)
  sobol_indices     ///< variance-based sensitivity indices (Saltelli 2010)
};

struct Sweep {
  Design design = Design::grid;
  std::int64_t samples =
      0;  ///< points; for the last two designs trajectories and base points; 0: not given
  std::vector<SweptKey> keys;                      ///< sorted by name
  std::vector<std::vector<std::string>> together;  ///< groups of keys that vary together
  std::map<std::string, std::string> derived;      ///< dotted key -> a formula of other keys
  bool empty() const { return keys.empty(); }
  bool operator==(const Sweep&) const = default;
};

/// A quantity of the summary that must stay on one side of a bound.
struct Limit {
  std::string quantity;
  bool below = true;
  std::string bound;  ///< as text: "1 mg/h"
  bool operator==(const Limit&) const = default;
};

/// Target and search ranges of `mahlwerk optimise`.
struct Optimise {
  std::string quantity;  ///< of the summary
  bool maximise = true;
  std::vector<SweptKey> over;  ///< search ranges, by name
  std::vector<Limit> limits;
  std::int64_t settings = 40;    ///< largest number of settings tried
  std::int64_t replicates = 16;  ///< largest number of replicates of one setting
  bool operator==(const Optimise&) const = default;
};

/// Keys of this mill that `mahlwerk match` may change to reproduce the collisions of another mill.
struct Match {
  std::vector<SweptKey> over;    ///< search ranges, by name
  std::int64_t settings = 40;    ///< largest number of settings tried
  std::int64_t replicates = 16;  ///< largest number of replicates of one setting
  bool operator==(const Match&) const = default;
};

}  // namespace mahlwerk::cases
