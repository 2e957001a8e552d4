// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/calibrate/posterior.hpp"

#include <algorithm>
#include <cmath>

#include "mahlwerk/campaign/fit/minimiser.hpp"

namespace mahlwerk::campaign {
namespace {

using Points = std::vector<std::vector<double>>;

struct MeanDeviation {
  double mean = 0, deviation = 0;
};

MeanDeviation moments(const std::vector<double>& values) {
  const auto count = static_cast<double>(values.size());
  MeanDeviation made;
  for (const double v : values) made.mean += v / count;
  for (const double v : values) made.deviation += (v - made.mean) * (v - made.mean) / count;
  made.deviation = std::sqrt(made.deviation);
  return made;
}

std::vector<double> coordinate(const Points& points, std::size_t i) {
  std::vector<double> made;
  for (const auto& point : points) made.push_back(point[i]);
  return made;
}

}  // namespace

double quantile_of(std::vector<double> values, double share) {
  std::ranges::sort(values);
  const double at = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(at);
  const std::size_t above = std::min(below + 1, values.size() - 1);
  return std::lerp(values[below], values[above], at - static_cast<double>(below));
}

std::size_t most_central(const Points& points) {
  std::vector<double> scale;
  for (std::size_t i = 0; i < points.front().size(); ++i)
    scale.push_back(std::max(1e-12, moments(coordinate(points, i)).deviation));
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < points.size(); ++k) {
    double sum = 0;
    for (const auto& other : points) {
      double square = 0;
      for (std::size_t i = 0; i < scale.size(); ++i) {
        const double off = (points[k][i] - other[i]) / scale[i];
        square += off * off;
      }
      sum += std::sqrt(square);
    }
    if (sum >= least) continue;
    least = sum;
    best = k;
  }
  return best;
}

Points thinned(const Points& points, std::size_t count) {
  Points made;
  for (std::size_t i = 0; i < std::min(count, points.size()); ++i)
    made.push_back(points[i * points.size() / std::min(count, points.size())]);
  return made;
}

Points correlation_of(const Points& points, std::size_t coordinates) {
  Points made(coordinates, std::vector<double>(coordinates, 1));
  for (std::size_t i = 0; i < coordinates; ++i)
    for (std::size_t k = 0; k < i; ++k) {
      const std::vector<double> a = coordinate(points, i), b = coordinate(points, k);
      const MeanDeviation of_a = moments(a), of_b = moments(b);
      double sum = 0;
      for (std::size_t n = 0; n < a.size(); ++n)
        sum += (a[n] - of_a.mean) * (b[n] - of_b.mean) / static_cast<double>(a.size());
      const double scale = of_a.deviation * of_b.deviation;
      made[i][k] = made[k][i] = scale > 0 ? sum / scale : 0;
    }
  return made;
}

FittedParameter describe_parameter(const FreeParameter& parameter,
                                   const std::vector<double>& positions, double central) {
  constexpr double flat = 0.28867513459481287;  // deviation of a uniform distribution
  constexpr double edge = 0.05;                 // of the range
  const double low = quantile_of(positions, 0.025), high = quantile_of(positions, 0.975);
  const auto share = [&](auto beyond) {
    return static_cast<double>(std::ranges::count_if(positions, beyond)) /
           static_cast<double>(positions.size());
  };
  FittedParameter made{parameter};
  made.value = value_at(parameter, central);
  made.low = value_at(parameter, low);
  made.high = value_at(parameter, high);
  // A limit within the range means that the posterior falls off before the end (cal.7).
  made.open_low = share([&](double u) { return u < edge; }) > edge / 2;
  made.open_high = share([&](double u) { return u > 1 - edge; }) > edge / 2;
  made.determined = moments(positions).deviation < 0.8 * flat && !(made.open_low && made.open_high);
  const auto end = [&](bool open, bool natural, const char* which) {
    if (open && made.determined && !natural)
      made.remarks.push_back(std::string("values at the ") + which +
                             " end of the range are possible: a wider range may move the interval");
  };
  end(made.open_low, parameter.min_is_natural, "lower");
  end(made.open_high, parameter.max_is_natural, "upper");
  if (!made.determined)
    made.remarks.emplace_back(
        "the measurements hardly depend on it: most of its range is possible");
  return made;
}

}  // namespace mahlwerk::campaign
