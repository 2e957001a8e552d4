// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <vector>

#include "mahlwerk/base/random.hpp"
#include "mahlwerk/campaign/run/parallel.hpp"
#include "mahlwerk/campaign/search/optimise.hpp"

namespace mahlwerk::tests {

/// Known functions with normal noise, in place of a simulation.
struct Noisy {
  using Function = std::function<double(const campaign::Place&)>;
  std::vector<Function> functions;  ///< what is to be best, then what is bounded
  double noise = 0;                 ///< standard deviation of each
  std::uint64_t seed = 1;
  int jobs = 1;
  std::function<bool(const campaign::Place&)> fails = {};
  std::function<bool(const campaign::Asked&, int replicate)> lacks = {};

  std::vector<campaign::Told> operator()(const std::vector<campaign::Asked>& asked) const {
    std::vector<campaign::Told> told(asked.size());
    campaign::in_parallel(jobs, asked.size(), [&](std::size_t i) { told[i] = answer(asked[i]); });
    return told;
  }

 private:
  campaign::Told answer(const campaign::Asked& one) const {
    campaign::Told told;
    if (fails && fails(one.place)) {
      told.failure = "too far";
      return told;
    }
    for (int replicate = one.first; replicate < one.first + one.count; ++replicate) {
      Random random(seed, static_cast<std::uint32_t>(1000 * one.setting) +
                              static_cast<std::uint32_t>(replicate));
      std::vector<double>& values = told.replicates.emplace_back();
      for (const Function& f : functions)
        values.push_back(f(one.place) + noise * campaign::normal_number(random));
      if (lacks && lacks(one, replicate)) values.front() = std::numeric_limits<double>::quiet_NaN();
    }
    return told;
  }
};

}  // namespace mahlwerk::tests
