// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mahlwerk/base/random.hpp"

// Gaussian process regression: a function of points from noisy observations
// (docs/theory/optimum.md).
namespace mahlwerk::campaign {

using DesignPoint = std::vector<double>;

/// Covariance function: Matern of order 5/2 with a length scale for each key, plus a constant
/// (opt.1).
struct Kernel {
  double amplitude = 1;               ///< standard deviation of the varying part
  std::vector<double> length_scales;  ///< by key, in coordinates of a DesignPoint
  double constant = 0;                ///< standard deviation of the constant
};
double covariance(const Kernel& kernel, const DesignPoint& a, const DesignPoint& b);

/// Observed mean at a point, and the variance of that mean.
struct Observation {
  DesignPoint point;
  double value = 0, variance = 0;
};

/// Mean and standard deviation of a normal posterior.
struct Posterior {
  double mean = 0, deviation = 0;
};

using SamplePath = std::function<double(const DesignPoint&)>;

/// A standard normal number by the Box-Muller transform.
double standard_normal(Random& random);
/// Cumulative distribution function of the standard normal distribution.
double normal_cdf(double z);

class GaussianProcess {
 public:
  GaussianProcess(Kernel kernel, std::vector<Observation> observations);

  Posterior at(const DesignPoint& point) const;  ///< of the function, without noise (opt.2)
  /// Posterior of each observation from all others, with its own noise (opt.18).
  std::vector<Posterior> leave_one_out() const;
  double log_evidence() const;  ///< log marginal likelihood of the observations (opt.3)
  const Kernel& kernel() const;
  const std::vector<Observation>& observations() const;

  /// Adds a fantasy observation: the posterior mean at `point`, with a variance.
  GaussianProcess with_fantasy(const DesignPoint& point, double variance) const;

  /// A sample path of the posterior (opt.11). Owns its data.
  SamplePath sample_path(Random& random) const;
  /// Values of `count` sample paths at `points`, by sample: exact, where `sample_path`
  /// approximates.
  std::vector<std::vector<double>> joint_samples(const std::vector<DesignPoint>& points, int count,
                                                 Random& random) const;

 private:
  struct Factorisation;
  std::shared_ptr<const Factorisation> factorisation_;
};

/// The kernel of the highest posterior density: likelihood times priors of length scales and
/// amplitude (opt.4). Values should have a mean near 0 and a standard deviation of about 1.
Kernel most_probable_kernel(const std::vector<Observation>& observations);

/// Kernels drawn from their posterior by slice sampling (Neal 2003), starting at `likeliest`.
std::vector<Kernel> sample_kernels(const std::vector<Observation>& observations,
                                   const Kernel& likeliest, int count, Random& random);

}  // namespace mahlwerk::campaign
