// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "mahlwerk/base/random.hpp"

// A function of places, guessed from values seen with noise (docs/theory/optimum.md).
namespace mahlwerk::campaign {

using Place = std::vector<double>;

/// How alike values at two places are: Matern's of order 5/2 with a length for each key, and a
/// constant (opt.1).
struct Kernel {
  double size = 1;              ///< standard deviation of what varies
  std::vector<double> lengths;  ///< by key, in places
  double level = 0;             ///< standard deviation of the constant
};
double covariance(const Kernel& kernel, const Place& a, const Place& b);

/// What was seen at a place: a mean, and the variance it has as one.
struct Seen {
  Place place;
  double value = 0, variance = 0;
};

/// A normal guess.
struct Belief {
  double mean = 0, deviation = 0;
};

using Path = std::function<double(const Place&)>;

/// Normal numbers by Box and Muller's rule.
double normal_number(Random& random);
/// Below z, of a normal number.
double normal_share(double z);

class GaussianProcess {
 public:
  GaussianProcess(Kernel kernel, std::vector<Seen> seen);

  Belief at(const Place& place) const;  ///< of the function, without the noise (opt.2)
  double evidence() const;              ///< ln of the probability of what was seen (opt.3)
  const Kernel& kernel() const;
  const std::vector<Seen>& seen() const;

  /// As if at `place` a value as expected had been seen.
  GaussianProcess believing(const Place& place, double variance) const;

  /// A function drawn from all that may be (opt.11); it lives on without this object.
  Path path(Random& random) const;
  /// Values of `count` such functions at some places: exact, where `path` is nearly so.
  std::vector<std::vector<double>> draws(const std::vector<Place>& places, int count,
                                         Random& random) const;

 private:
  struct Solved;
  std::shared_ptr<const Solved> solved_;
};

/// The kernel under which what was seen is likeliest, lengths and size being likelier in the middle
/// of what is usual (opt.4); values should have a mean near 0 and scatter by about 1.
Kernel likeliest_kernel(const std::vector<Seen>& seen);

/// Kernels drawn as likely as they are, by slices (Neal 2003).
std::vector<Kernel> plausible_kernels(const std::vector<Seen>& seen, const Kernel& likeliest,
                                      int count, Random& random);

}  // namespace mahlwerk::campaign
