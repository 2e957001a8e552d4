// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/gaussian_process.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "mahlwerk/base/elementary.hpp"

namespace mahlwerk::campaign {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

/// Keeps the matrix positive definite despite rounding; relative to the variance.
constexpr double jitter = 1e-9;

double matern(const Kernel& k, const double* a, const double* b) {
  double square = 0;
  for (std::size_t i = 0; i < k.length_scales.size(); ++i) {
    const double step = (a[i] - b[i]) / k.length_scales[i];
    square += step * step;
  }
  const double r = std::sqrt(5 * square);
  return k.amplitude * k.amplitude * (1 + r + r * r / 3) * math::exp(-r) +
         k.constant * k.constant;  // (opt.1)
}

double prior_variance(const Kernel& k) {
  return k.amplitude * k.amplitude + k.constant * k.constant;
}

}  // namespace

double covariance(const Kernel& kernel, const DesignPoint& a, const DesignPoint& b) {
  return matern(kernel, a.data(), b.data());
}

double standard_normal(Random& random) {
  const double size = std::sqrt(-2 * math::log(random.uniform()));
  return size * math::cos(2 * std::numbers::pi * random.uniform());
}

double normal_cdf(double z) {
  return 0.5 * math::erfc(-z / std::numbers::sqrt2);
}

/// The process with the Cholesky factor of its covariance matrix.
struct GaussianProcess::Factorisation {
  Kernel kernel;
  std::vector<Observation> observations;
  Eigen::LLT<MatrixXd> root;
  VectorXd weights;  // of the observations in the posterior mean: (K + V)^-1 y

  VectorXd covariances(const DesignPoint& point) const {
    VectorXd k(observations.size());
    for (std::size_t i = 0; i < observations.size(); ++i)
      k(static_cast<Index>(i)) = covariance(kernel, point, observations[i].point);
    return k;
  }
};

GaussianProcess::GaussianProcess(Kernel kernel, std::vector<Observation> observations) {
  auto made = std::make_shared<Factorisation>();
  made->kernel = std::move(kernel);
  made->observations = std::move(observations);
  const auto n = static_cast<Index>(made->observations.size());
  MatrixXd all(n, n);
  VectorXd values(n);
  for (Index i = 0; i < n; ++i) {
    const Observation& one = made->observations[static_cast<std::size_t>(i)];
    for (Index j = 0; j < i; ++j)
      all(i, j) = all(j, i) = covariance(made->kernel, one.point,
                                         made->observations[static_cast<std::size_t>(j)].point);
    all(i, i) = prior_variance(made->kernel) * (1 + jitter) + one.variance;
    values(i) = one.value;
  }
  made->root.compute(all);
  made->weights = made->root.solve(values);
  factorisation_ = std::move(made);
}

Posterior GaussianProcess::at(const DesignPoint& point) const {
  const VectorXd k = factorisation_->covariances(point);
  const double known = factorisation_->root.matrixL().solve(k).squaredNorm();
  return {k.dot(factorisation_->weights),
          std::sqrt(std::max(0.0, prior_variance(factorisation_->kernel) - known))};
}

std::vector<Posterior> GaussianProcess::leave_one_out() const {
  const auto n = static_cast<Index>(factorisation_->observations.size());
  const MatrixXd inverse = factorisation_->root.solve(MatrixXd::Identity(n, n));
  std::vector<Posterior> made;
  for (Index i = 0; i < n; ++i) {
    const double variance = 1 / inverse(i, i);
    made.push_back({factorisation_->observations[static_cast<std::size_t>(i)].value -
                        variance * factorisation_->weights(i),
                    std::sqrt(variance)});
  }
  return made;  // (opt.18)
}

double GaussianProcess::log_evidence() const {
  double fit = 0, volume = 0;
  const MatrixXd& root = factorisation_->root.matrixLLT();
  for (std::size_t i = 0; i < factorisation_->observations.size(); ++i) {
    const auto at = static_cast<Index>(i);
    fit += factorisation_->observations[i].value * factorisation_->weights(at);
    volume += math::log(2 * std::numbers::pi) / 2 + math::log(root(at, at));
  }
  return -fit / 2 - volume;  // (opt.3)
}

const Kernel& GaussianProcess::kernel() const {
  return factorisation_->kernel;
}

const std::vector<Observation>& GaussianProcess::observations() const {
  return factorisation_->observations;
}

GaussianProcess GaussianProcess::with_fantasy(const DesignPoint& point, double variance) const {
  std::vector<Observation> more = factorisation_->observations;
  more.push_back({point, at(point).mean, variance});
  return {factorisation_->kernel, std::move(more)};
}

SamplePath GaussianProcess::sample_path(Random& random) const {
  constexpr Index waves = 128;
  const Kernel& kernel = factorisation_->kernel;
  const auto keys = static_cast<Index>(kernel.length_scales.size());
  MatrixXd pace(waves, keys);
  VectorXd phase(waves), weight(waves);
  for (Index m = 0; m < waves; ++m) {  // spectral density: Student's t with 5 degrees of freedom
    double square = 0;
    for (int i = 0; i < 5; ++i) {
      const double drawn = standard_normal(random);
      square += drawn * drawn;
    }
    for (Index i = 0; i < keys; ++i)
      pace(m, i) = standard_normal(random) / std::sqrt(square / 5) /
                   kernel.length_scales[static_cast<std::size_t>(i)];
    phase(m) = 2 * std::numbers::pi * random.uniform();
    weight(m) = kernel.amplitude * std::sqrt(2.0 / waves) * standard_normal(random);
  }
  const double level = kernel.constant * standard_normal(random);
  const auto before = [=](const DesignPoint& point) {
    const Eigen::Map<const VectorXd> x(point.data(), keys);
    return level + weight.dot((pace * x + phase).array().cos().matrix());
  };
  VectorXd off(factorisation_->observations.size());
  for (std::size_t i = 0; i < factorisation_->observations.size(); ++i) {
    const Observation& one = factorisation_->observations[i];
    off(static_cast<Index>(i)) =
        one.value - before(one.point) - std::sqrt(one.variance) * standard_normal(random);
  }
  const VectorXd pull = factorisation_->root.solve(off);
  return [before, pull, solved = factorisation_](const DesignPoint& point) {
    return before(point) + pull.dot(solved->covariances(point));  // (opt.11)
  };
}

std::vector<std::vector<double>> GaussianProcess::joint_samples(
    const std::vector<DesignPoint>& points, int count, Random& random) const {
  const auto n = static_cast<Index>(points.size());
  MatrixXd apart(factorisation_->observations.size(), n), among(n, n);
  VectorXd mean(n);
  for (Index i = 0; i < n; ++i) {
    const DesignPoint& point = points[static_cast<std::size_t>(i)];
    const VectorXd k = factorisation_->covariances(point);
    mean(i) = k.dot(factorisation_->weights);
    apart.col(i) = factorisation_->root.matrixL().solve(k);
    for (Index j = 0; j <= i; ++j)
      among(i, j) = among(j, i) =
          covariance(factorisation_->kernel, point, points[static_cast<std::size_t>(j)]);
  }
  among -= apart.transpose() * apart;
  // Near observations the covariance is mostly rounding: eigenvalues below 0 become 0.
  const Eigen::SelfAdjointEigenSolver<MatrixXd> axes(among);
  const MatrixXd root =
      axes.eigenvectors() * axes.eigenvalues().cwiseMax(0).cwiseSqrt().asDiagonal();
  std::vector<std::vector<double>> made;
  for (int draw = 0; draw < count; ++draw) {
    VectorXd z(n);
    for (Index i = 0; i < n; ++i) z(i) = standard_normal(random);
    const VectorXd values = mean + root * z;
    made.emplace_back(values.begin(), values.end());
  }
  return made;
}

}  // namespace mahlwerk::campaign
