// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/gaussian_process.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace mahlwerk::campaign {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Lets rounding not make a matrix indefinite; in parts of the variance.
constexpr double jitter = 1e-9;

double alike(const Kernel& k, const double* a, const double* b) {
  double square = 0;
  for (std::size_t i = 0; i < k.lengths.size(); ++i) {
    const double step = (a[i] - b[i]) / k.lengths[i];
    square += step * step;
  }
  const double r = std::sqrt(5 * square);
  return k.size * k.size * (1 + r + r * r / 3) * std::exp(-r) + k.level * k.level;  // (opt.1)
}

double own(const Kernel& k) {
  return k.size * k.size + k.level * k.level;
}

}  // namespace

double covariance(const Kernel& kernel, const Place& a, const Place& b) {
  return alike(kernel, a.data(), b.data());
}

double normal_number(Random& random) {
  const double size = std::sqrt(-2 * std::log(random.uniform()));
  return size * std::cos(2 * std::numbers::pi * random.uniform());
}

double normal_share(double z) {
  return 0.5 * std::erfc(-z / std::numbers::sqrt2);
}

/// The process with its matrix taken apart.
struct GaussianProcess::Solved {
  Kernel kernel;
  std::vector<Seen> seen;
  Eigen::LLT<MatrixXd> root;
  VectorXd weights;  // of what was seen, in a guess

  VectorXd with(const Place& place) const {
    VectorXd k(seen.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
      k(static_cast<Index>(i)) = covariance(kernel, place, seen[i].place);
    return k;
  }
};

GaussianProcess::GaussianProcess(Kernel kernel, std::vector<Seen> seen) {
  auto made = std::make_shared<Solved>();
  made->kernel = std::move(kernel);
  made->seen = std::move(seen);
  const auto n = static_cast<Index>(made->seen.size());
  MatrixXd all(n, n);
  VectorXd values(n);
  for (Index i = 0; i < n; ++i) {
    const Seen& one = made->seen[static_cast<std::size_t>(i)];
    for (Index j = 0; j < i; ++j)
      all(i, j) = all(j, i) =
          covariance(made->kernel, one.place, made->seen[static_cast<std::size_t>(j)].place);
    all(i, i) = own(made->kernel) * (1 + jitter) + one.variance;
    values(i) = one.value;
  }
  made->root.compute(all);
  made->weights = made->root.solve(values);
  solved_ = std::move(made);
}

Belief GaussianProcess::at(const Place& place) const {
  const VectorXd k = solved_->with(place);
  const double known = solved_->root.matrixL().solve(k).squaredNorm();
  return {k.dot(solved_->weights), std::sqrt(std::max(0.0, own(solved_->kernel) - known))};
}

double GaussianProcess::evidence() const {
  double fit = 0, volume = 0;
  const MatrixXd& root = solved_->root.matrixLLT();
  for (std::size_t i = 0; i < solved_->seen.size(); ++i) {
    const auto at = static_cast<Index>(i);
    fit += solved_->seen[i].value * solved_->weights(at);
    volume += std::log(2 * std::numbers::pi) / 2 + std::log(root(at, at));
  }
  return -fit / 2 - volume;  // (opt.3)
}

const Kernel& GaussianProcess::kernel() const {
  return solved_->kernel;
}

const std::vector<Seen>& GaussianProcess::seen() const {
  return solved_->seen;
}

GaussianProcess GaussianProcess::believing(const Place& place, double variance) const {
  std::vector<Seen> more = solved_->seen;
  more.push_back({place, at(place).mean, variance});
  return {solved_->kernel, std::move(more)};
}

Path GaussianProcess::path(Random& random) const {
  constexpr Index waves = 128;
  const Kernel& kernel = solved_->kernel;
  const auto keys = static_cast<Index>(kernel.lengths.size());
  MatrixXd pace(waves, keys);
  VectorXd phase(waves), weight(waves);
  for (Index m = 0; m < waves; ++m) {  // frequencies of order 5/2: Student's t of 5 freedoms
    double square = 0;
    for (int i = 0; i < 5; ++i) square += std::pow(normal_number(random), 2);
    for (Index i = 0; i < keys; ++i)
      pace(m, i) = normal_number(random) / std::sqrt(square / 5) /
                   kernel.lengths[static_cast<std::size_t>(i)];
    phase(m) = 2 * std::numbers::pi * random.uniform();
    weight(m) = kernel.size * std::sqrt(2.0 / waves) * normal_number(random);
  }
  const double level = kernel.level * normal_number(random);
  const auto before = [=](const Place& place) {
    const Eigen::Map<const VectorXd> x(place.data(), keys);
    return level + weight.dot((pace * x + phase).array().cos().matrix());
  };
  VectorXd off(solved_->seen.size());
  for (std::size_t i = 0; i < solved_->seen.size(); ++i) {
    const Seen& one = solved_->seen[i];
    off(static_cast<Index>(i)) =
        one.value - before(one.place) - std::sqrt(one.variance) * normal_number(random);
  }
  const VectorXd pull = solved_->root.solve(off);
  return [before, pull, solved = solved_](const Place& place) {
    return before(place) + pull.dot(solved->with(place));  // (opt.11)
  };
}

std::vector<std::vector<double>> GaussianProcess::draws(const std::vector<Place>& places, int count,
                                                        Random& random) const {
  const auto n = static_cast<Index>(places.size());
  MatrixXd apart(solved_->seen.size(), n), among(n, n);
  VectorXd mean(n);
  for (Index i = 0; i < n; ++i) {
    const Place& place = places[static_cast<std::size_t>(i)];
    const VectorXd k = solved_->with(place);
    mean(i) = k.dot(solved_->weights);
    apart.col(i) = solved_->root.matrixL().solve(k);
    for (Index j = 0; j <= i; ++j)
      among(i, j) = among(j, i) =
          covariance(solved_->kernel, place, places[static_cast<std::size_t>(j)]);
  }
  among -= apart.transpose() * apart;
  // What is all but known may have lost its last digits: eigenvalues below 0 are rounding.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(among);
  const MatrixXd root =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  std::vector<std::vector<double>> made;
  for (int draw = 0; draw < count; ++draw) {
    VectorXd z(n);
    for (Index i = 0; i < n; ++i) z(i) = normal_number(random);
    const VectorXd values = mean + root * z;
    made.emplace_back(values.begin(), values.end());
  }
  return made;
}

}  // namespace mahlwerk::campaign
