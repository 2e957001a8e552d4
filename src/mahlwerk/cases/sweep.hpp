// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

// What a case says of many runs: which of its keys vary, and what is looked for among them.
namespace mahlwerk::cases {

/// A key of the case that varies, and the values it takes.
struct SweptKey {
  std::string key;                  ///< "mill.speed", "balls.2.diameter"
  std::vector<std::string> values;  ///< as text; of a range its two ends
  bool range = false;               ///< whatever lies between two ends
  std::int64_t steps = 0;           ///< of a range: so many values on a grid; 0: not said
  bool logarithmic = false;         ///< of a range: by equal ratios
  bool operator==(const SweptKey&) const = default;
};

/// How the points of a campaign are chosen (docs/theory/campaigns.md).
enum class Design {
  grid,             ///< each combination
  latin_hypercube,  ///< each key's range cut into as many parts as there are points, one in each
  sobol,            ///< evenly spread over the ranges (Sobol' 1967)
  one_at_a_time,    ///< the case itself, then each key alone at its ends
  morris,           ///< elementary effects along random ways (Morris 1991)
  sobol_indices     ///< shares of variance (Saltelli 2010)
};

struct Sweep {
  Design design = Design::grid;
  std::int64_t samples =
      0;  ///< points, or ways and base points of the last two designs; 0: not said
  std::vector<SweptKey> keys;                      ///< by name
  std::vector<std::vector<std::string>> together;  ///< keys whose lists go side by side
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

/// What `mahlwerk optimise` looks for.
struct Optimise {
  std::string quantity;  ///< of the summary
  bool maximise = true;
  std::vector<SweptKey> over;  ///< ranges, by name
  std::vector<Limit> limits;
  std::int64_t settings = 40;    ///< tried at most
  std::int64_t replicates = 16;  ///< of one setting at most
  bool operator==(const Optimise&) const = default;
};

/// What `mahlwerk match` may change in this mill to make it do what another does.
struct Match {
  std::vector<SweptKey> over;    ///< ranges, by name
  std::int64_t settings = 40;    ///< tried at most
  std::int64_t replicates = 16;  ///< of one setting at most
  bool operator==(const Match&) const = default;
};

}  // namespace mahlwerk::cases
