// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// Posterior of the kernel's parameters, given the observations (docs/theory/optimum.md).
#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/campaign/search/gaussian_process.hpp"
#include "mahlwerk/campaign/search/maximum.hpp"

namespace mahlwerk::campaign {
namespace {

/// Priors of the logarithms of amplitude and length scales: mean, standard deviation and bounds
/// (opt.4).
constexpr double usual_size = 0, size_spread = 1, length_spread = 0.6;
constexpr double min_size = -3, max_size = 4, min_length = -4, max_length = 4;
constexpr double usual_constant = 3;

double usual_length(std::size_t keys) {
  return math::log(0.6 * std::sqrt(static_cast<double>(keys)));
}

Kernel kernel_of(const std::vector<double>& numbers) {
  Kernel kernel{
      .amplitude = math::exp(numbers.front()), .length_scales = {}, .constant = usual_constant};
  for (std::size_t i = 1; i < numbers.size(); ++i)
    kernel.length_scales.push_back(math::exp(numbers[i]));
  return kernel;
}

/// Logarithm of a normal prior, without its constant.
double log_prior(double value, double mean, double deviation) {
  const double z = (value - mean) / deviation;
  return -z * z / 2;
}

double log_posterior(const std::vector<Observation>& observations,
                     const std::vector<double>& numbers) {
  double likely = log_prior(numbers.front(), usual_size, size_spread);
  const double usual = usual_length(numbers.size() - 1);
  for (std::size_t i = 1; i < numbers.size(); ++i)
    likely += log_prior(numbers[i], usual, length_spread);
  return likely + GaussianProcess(kernel_of(numbers), observations).log_evidence();
}

/// Draws number `i` from its conditional distribution by slice sampling with stepping out (Neal
/// 2003, figures 3, 5).
void draw_along(std::vector<double>& at, double& likely, std::size_t i,
                const std::vector<Observation>& observations, Random& random) {
  constexpr double width = 1.5;
  const double low = i == 0 ? min_size : min_length, high = i == 0 ? max_size : max_length;
  const double height = likely + math::log(random.uniform());
  const double here = at[i];
  const auto value = [&](double x) {
    if (x < low || x > high) return -1e300;
    at[i] = x;
    return log_posterior(observations, at);
  };
  double left = here - width * random.uniform(), right = left + width;
  for (int step = 0; step < 3 && value(left) > height; ++step) left -= width;
  for (int step = 0; step < 3 && value(right) > height; ++step) right += width;
  for (int trial = 0; trial < 30; ++trial) {
    const double x = random.uniform(left, right), found = value(x);
    if (found > height) {
      at[i] = x;
      likely = found;
      return;
    }
    (x < here ? left : right) = x;
  }
  at[i] = here;
}

}  // namespace

Kernel most_probable_kernel(const std::vector<Observation>& observations) {
  const std::size_t keys = observations.front().point.size();
  std::vector<double> least(keys + 1, min_length), most(keys + 1, max_length);
  least.front() = min_size;
  most.front() = max_size;
  std::vector<double> usual(keys + 1, usual_length(keys));
  usual.front() = usual_size;
  std::vector<double> narrow = usual;
  for (std::size_t i = 1; i <= keys; ++i) narrow[i] -= 1.2;
  const int effort = 40 * static_cast<int>(keys + 1);
  return kernel_of(
      find_maximum([&](const std::vector<double>& at) { return log_posterior(observations, at); },
                   least, most, {usual, narrow}, {.global = 0, .local = effort})
          .point);
}

std::vector<Kernel> sample_kernels(const std::vector<Observation>& observations,
                                   const Kernel& likeliest, int count, Random& random) {
  constexpr int forget = 5;  // burn-in sweeps
  std::vector<double> at{math::log(likeliest.amplitude)};
  for (const double length : likeliest.length_scales) at.push_back(math::log(length));
  double likely = log_posterior(observations, at);
  std::vector<Kernel> made;
  for (int sweep = 0; sweep < forget + count; ++sweep) {
    for (std::size_t i = 0; i < at.size(); ++i) draw_along(at, likely, i, observations, random);
    if (sweep >= forget) made.push_back(kernel_of(at));
  }
  return made;
}

}  // namespace mahlwerk::campaign
