// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/powder/thermocouple.hpp"

#include <cstddef>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::powder {

std::vector<double> thermocouple_readings(std::span<const double> times,
                                          std::span<const double> around, double lag) {
  std::vector<double> readings;
  if (times.empty()) return readings;
  readings.push_back(around[0]);
  for (std::size_t i = 1; i < times.size(); ++i) {
    const double step = times[i] - times[i - 1];
    if (!(step > 0) || lag == 0) {
      readings.push_back(lag == 0 ? around[i] : readings.back());
      continue;
    }
    const double slope = (around[i] - around[i - 1]) / step;
    // A ramp is followed at a distance of slope times lag (sns.8).
    const double behind = readings.back() - around[i - 1] + slope * lag;
    readings.push_back(around[i] - slope * lag + behind * math::exp(-step / lag));
  }
  return readings;
}

double gas_temperature(double balls, double balls_area, double wall, double wall_area) {
  return (balls_area * balls + wall_area * wall) / (balls_area + wall_area);
}

}  // namespace mahlwerk::powder
