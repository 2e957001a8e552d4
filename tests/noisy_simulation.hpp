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

/// Known functions plus normally distributed noise, in place of a simulation.
struct NoisySimulation {
  using Function = std::function<double(const campaign::DesignPoint&)>;
  std::vector<Function> functions;  ///< the objective, then the constrained outcomes
  double noise = 0;                 ///< standard deviation of the noise of each function
  std::uint64_t seed = 1;
  int jobs = 1;
  std::function<bool(const campaign::DesignPoint&)> fails = {};
  std::function<bool(const campaign::TrialRequest&, int replicate)> is_missing = {};

  std::vector<campaign::TrialResult> operator()(
      const std::vector<campaign::TrialRequest>& asked) const {
    std::vector<campaign::TrialResult> result(asked.size());
    campaign::in_parallel(jobs, asked.size(), [&](std::size_t i) { result[i] = answer(asked[i]); });
    return result;
  }

 private:
  campaign::TrialResult answer(const campaign::TrialRequest& one) const {
    campaign::TrialResult result;
    if (fails && fails(one.point)) {
      result.failure = "too far";
      return result;
    }
    for (int replicate = one.first; replicate < one.first + one.count; ++replicate) {
      Random random(seed, static_cast<std::uint32_t>(1000 * one.setting) +
                              static_cast<std::uint32_t>(replicate));
      std::vector<double>& values = result.replicates.emplace_back();
      for (const Function& f : functions)
        values.push_back(f(one.point) + noise * campaign::standard_normal(random));
      if (is_missing && is_missing(one, replicate))
        values.front() = std::numeric_limits<double>::quiet_NaN();
    }
    return result;
  }
};

}  // namespace mahlwerk::tests
