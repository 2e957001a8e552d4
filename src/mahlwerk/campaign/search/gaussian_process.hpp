// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mahlwerk/base/random.hpp"

// A function of points, guessed from values seen with noise (docs/theory/optimum.md).
namespace mahlwerk::campaign {

using DesignPoint = std::vector<double>;

/// How alike values at two points are: Matern's of order 5/2 with a length for each key, and a
/// constant (opt.1).
struct Kernel {
  double amplitude = 1;               ///< standard deviation of what varies
  std::vector<double> length_scales;  ///< by key, in points
  double constant = 0;                ///< standard deviation of the constant
};
double covariance(const Kernel& kernel, const DesignPoint& a, const DesignPoint& b);

/// What was seen at a point: a mean, and the variance it has as one.
struct Observation {
  DesignPoint point;
  double value = 0, variance = 0;
};

/// A normal guess.
struct Posterior {
  double mean = 0, deviation = 0;
};

using SamplePath = std::function<double(const DesignPoint&)>;

/// Normal numbers by Box and Muller's rule.
double standard_normal(Random& random);
/// Below z, of a normal number.
double normal_cdf(double z);

class GaussianProcess {
 public:
  GaussianProcess(Kernel kernel, std::vector<Observation> observations);

  Posterior at(const DesignPoint& point) const;  ///< of the function, without the noise (opt.2)
  double log_evidence() const;                   ///< ln of the probability of what was seen (opt.3)
  const Kernel& kernel() const;
  const std::vector<Observation>& observations() const;

  /// As if at `point` a value as expected had been seen.
  GaussianProcess with_fantasy(const DesignPoint& point, double variance) const;

  /// A function drawn from all that may be (opt.11); it lives on without this object.
  SamplePath sample_path(Random& random) const;
  /// Values of `count` such functions at some points: exact, where `sample_path` is nearly so.
  std::vector<std::vector<double>> joint_samples(const std::vector<DesignPoint>& points, int count,
                                                 Random& random) const;

 private:
  struct Factorisation;
  std::shared_ptr<const Factorisation> factorisation_;
};

/// The kernel under which what was seen is likeliest, lengths and size being likelier in the middle
/// of what is usual (opt.4); values should have a mean near 0 and scatter by about 1.
Kernel most_probable_kernel(const std::vector<Observation>& observations);

/// Kernels drawn as likely as they are, by slices (Neal 2003).
std::vector<Kernel> sample_kernels(const std::vector<Observation>& observations,
                                   const Kernel& likeliest, int count, Random& random);

}  // namespace mahlwerk::campaign
