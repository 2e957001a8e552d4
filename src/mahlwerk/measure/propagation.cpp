// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/measure/propagation.hpp"

#include <cmath>

namespace mahlwerk::measure {

Propagated propagated(
    const std::vector<observe::Estimate>& inputs,
    const std::function<std::vector<double>(const std::vector<double>&)>& results) {
  std::vector<double> values;
  for (const observe::Estimate& input : inputs) values.push_back(input.mean);
  const std::vector<double> at = results(values);
  const std::size_t n = at.size();
  Propagated made{{}, std::vector<double>(n * n, 0)};
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    if (!(inputs[k].ci95 > 0)) continue;
    std::vector<double> up = values, down = values;
    up[k] += 0.5 * inputs[k].ci95;
    down[k] -= 0.5 * inputs[k].ci95;
    const std::vector<double> high = results(up), low = results(down);
    for (std::size_t i = 0; i < n; ++i)
      for (std::size_t j = 0; j < n; ++j)
        made.covariance[i * n + j] += (high[i] - low[i]) * (high[j] - low[j]);
  }
  for (std::size_t i = 0; i < n; ++i)
    made.results.push_back({at[i], std::sqrt(made.covariance[i * n + i])});
  return made;
}

}  // namespace mahlwerk::measure
