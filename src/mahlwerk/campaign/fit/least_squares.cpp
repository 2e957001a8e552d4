// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/least_squares.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "mahlwerk/campaign/fit/minimiser.hpp"
#include "mahlwerk/observe/statistics.hpp"

namespace mahlwerk::campaign {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

constexpr double infinite = std::numeric_limits<double>::infinity();

/// Differences of the sum of squares below this are rounding.
double rounding(const std::vector<Evaluation>& seen) {
  std::vector<double> sums;
  for (const Evaluation& point : seen)
    if (std::isfinite(point.sum)) sums.push_back(point.sum);
  std::ranges::sort(sums);
  return 1e-20 * sums[sums.size() / 2];
}

/// Rise of the sum of squares at the ends of a 95 % interval (fit.4).
double allowed_rise(double sum, int freedom, ErrorScale scatter) {
  constexpr double normal = 1.959963984540054;
  const double known = scatter == ErrorScale::known ? normal * normal : 0;
  if (freedom < 1) return scatter == ErrorScale::known ? known : infinite;
  const double t = observe::student95(freedom);
  return std::max(known, t * t * sum / freedom);
}

/// Profile likelihood: the position of parameter `i`, from the best one towards 0 or 1, at which
/// the sum of squares, minimised over the other parameters, has risen by `rise` (fit.5). `guess` is
/// the linear estimate of the distance, `along` the linear change of all parameters by that of
/// parameter `i`.
struct Limit {
  double position;
  bool open;
};
Limit limit(Minimiser& search, const Evaluation& best, std::size_t i, bool up, double rise,
            double guess, const VectorXd& along) {
  constexpr double sharp = 1e-9, enough = 0.01;
  const double end = up ? 1 : 0, room = std::abs(end - best.position[i]), side = up ? 1 : -1;
  if (guess < std::min(sharp, room)) return {best.position[i] + side * guess, false};
  if (!std::isfinite(rise)) return {end, true};
  double inside = 0, inside_rise = 0, outside = infinite, outside_rise = 0;
  double way = std::min(guess, room);
  std::vector<double> step(along.begin(), along.end());  // of all, relative to parameter i
  for (int round = 0; round < 15; ++round) {
    std::vector<double> position = best.position;
    for (std::size_t k = 0; k < position.size(); ++k)
      position[k] = std::clamp(position[k] + side * way * step[k], 0.0, 1.0);
    position[i] = way >= room ? end : best.position[i] + side * way;
    const Evaluation at = search.levenberg_marquardt(search.evaluate(position), i);
    const double risen = std::sqrt(std::max(0.0, (at.sum - best.sum) / rise));  // near linear
    if (risen <= 1) {
      if (way >= room) return {end, true};
      inside = way, inside_rise = risen;
      for (std::size_t k = 0; k < step.size(); ++k)
        step[k] = (at.position[k] - best.position[k]) / (side * way);
    } else {
      outside = way, outside_rise = risen;
    }
    if (std::abs(risen - 1) < enough) break;
    if (std::isfinite(outside)) {
      const double share =
          std::isfinite(outside_rise) ? (1 - inside_rise) / (outside_rise - inside_rise) : 0.5;
      way = inside + std::clamp(share, 0.1, 0.9) * (outside - inside);
    } else {
      way = std::min(room, std::clamp(1.02 * way / risen, 1.1 * way, 4 * way));
    }
  }
  return {best.position[i] + side * std::min(outside, std::max(inside, way)), false};
}

/// Linear analysis at the best position: covariance of the parameters, and directions that the data
/// do not determine (fit.6).
struct Curvature {
  MatrixXd covariance;  ///< in positions, for residuals of unit scatter
  /// For each direction along which no residual changes: its parameters.
  std::vector<std::vector<std::size_t>> flat;
};
Curvature curvature(const std::vector<std::vector<double>>& columns) {
  constexpr double flat = 1e-6, part = 0.1, deepest = 1e-8;
  MatrixXd slopes(columns.front().size(), columns.size());
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t k = 0; k < columns[i].size(); ++k)
      slopes(static_cast<Index>(k), static_cast<Index>(i)) = columns[i][k];
  const Eigen::JacobiSVD<MatrixXd> svd(slopes, Eigen::ComputeFullV);
  VectorXd size = VectorXd::Zero(slopes.cols());
  size.head(svd.singularValues().size()) = svd.singularValues();
  Curvature made;
  for (Index k = 0; k < size.size(); ++k) {
    if (size(k) > flat * size(0)) continue;
    const VectorXd direction = svd.matrixV().col(k).cwiseAbs();
    std::vector<std::size_t> in;
    for (Index i = 0; i < direction.size(); ++i)
      if (direction(i) > part * direction.maxCoeff()) in.push_back(static_cast<std::size_t>(i));
    made.flat.push_back(std::move(in));
  }
  const double least = size(0) > 0 ? deepest * size(0) : 1e-100;
  const VectorXd inverse = size.cwiseMax(least).cwiseInverse();
  made.covariance = svd.matrixV() * inverse.cwiseAbs2().asDiagonal() * svd.matrixV().transpose();
  return made;
}

std::vector<std::vector<double>> correlation(const MatrixXd& covariance) {
  const auto n = static_cast<std::size_t>(covariance.rows());
  std::vector<std::vector<double>> rows(n, std::vector<double>(n, 1));
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t k = 0; k < n; ++k) {
      const auto a = static_cast<Index>(std::min(i, k)), b = static_cast<Index>(std::max(i, k));
      if (i != k)  // (fit.7)
        rows[i][k] = covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
    }
  return rows;
}

using Limits = std::array<Limit, 2>;  // below and above

/// The best position, and the limits of each parameter. If the search for limits finds a better
/// position, all limits are searched again from there.
struct BestFit {
  Evaluation best;
  double rise = 0;
  Curvature curvature;
  std::vector<Limits> limits;
};
BestFit find_best_fit(Minimiser& search, ErrorScale scatter) {
  constexpr int max_times = 3;
  BestFit made;
  const std::vector<Evaluation> begin = search.start_points();
  const double min_rise = rounding(search.evaluations());
  for (const Evaluation& start : begin) {
    Evaluation end = search.levenberg_marquardt(search.subplex_search(start));
    if (end.sum < made.best.sum) made.best = std::move(end);
  }
  const auto freedom =
      static_cast<int>(made.best.residuals.size()) - static_cast<int>(search.count());
  for (int time = 1;; ++time) {
    made.rise = std::max(min_rise, allowed_rise(made.best.sum, freedom, scatter));
    made.curvature = curvature(search.slopes(made.best, true));
    made.limits.clear();
    for (std::size_t i = 0; i < search.count(); ++i) {
      const auto at = static_cast<Index>(i);
      const double spread = made.curvature.covariance(at, at),
                   guess = std::sqrt(made.rise * spread);
      const VectorXd along = made.curvature.covariance.col(at) / spread;
      made.limits.push_back({limit(search, made.best, i, false, made.rise, guess, along),
                             limit(search, made.best, i, true, made.rise, guess, along)});
    }
    const Evaluation& lower = *std::ranges::min_element(search.evaluations(), {}, &Evaluation::sum);
    if (time == max_times || !(lower.sum < made.best.sum - 1e-3 * made.rise)) return made;
    made.best = search.levenberg_marquardt(search.evaluate(std::vector(lower.position)));
  }
}

/// Extends the limits of parameter `i` to all evaluated positions that fit as well; true if any of
/// them lay far outside.
bool widen(Limits& limits, const BestFit& best_fit, const std::vector<Evaluation>& seen,
           std::size_t i) {
  const double far = 0.05 * (limits[1].position - limits[0].position);
  const double low = limits[0].position - far, high = limits[1].position + far;
  for (const Evaluation& point : seen) {
    if (!(point.sum <= best_fit.best.sum + best_fit.rise)) continue;
    const double position = point.position[i];
    if (position < limits[0].position) limits[0] = {position, position <= 0};
    if (position > limits[1].position) limits[1] = {position, position >= 1};
  }
  return limits[0].position < low || limits[1].position > high;
}

/// The names of the other parameters in `of`, as a list.
std::string others(const std::vector<std::size_t>& of, std::size_t i,
                   const std::vector<FreeParameter>& parameters) {
  std::string list;
  for (const std::size_t k : of)
    if (k != i) list += (list.empty() ? "" : ", ") + parameters[k].name;
  return list;
}

/// Adds remarks on a parameter's interval.
void remark(const FreeParameter& range, double position, FittedParameter& p) {
  constexpr double at_end = 1e-6;
  if (p.open_low && p.open_high)
    p.remarks.push_back("any value of its range fits within the scatter of the data");
  else if (p.open_low || p.open_high)
    p.remarks.push_back(
        fmt::format("the data give no {} limit within its range", p.open_low ? "lower" : "upper"));
  const bool low = position<at_end, high = position> 1 - at_end;
  if (low || high)
    p.remarks.push_back(fmt::format(
        "the best value lies at the {} end of its range{}", low ? "lower" : "upper",
        (low ? range.min_is_natural : range.max_is_natural) ? ", beyond which it makes no sense"
                                                            : "; a wider range may fit better"));
}

FittedParameter fitted(const BestFit& best_fit, const Minimiser& search,
                       const std::vector<FreeParameter>& parameters, std::size_t i) {
  const FreeParameter& range = parameters[i];
  const double position = best_fit.best.position[i];
  Limits limits = best_fit.limits[i];
  const bool elsewhere = widen(limits, best_fit, search.evaluations(), i);
  FittedParameter p{range};
  p.value = value_at(range, position);
  p.low = value_at(range, limits[0].position);
  p.high = value_at(range, limits[1].position);
  p.open_low = limits[0].open;
  p.open_high = limits[1].open;
  p.determined = !(p.open_low && p.open_high);
  for (const std::vector<std::size_t>& flat : best_fit.curvature.flat) {
    if (std::ranges::find(flat, i) == flat.end()) continue;
    p.determined = false;
    p.remarks.push_back(flat.size() == 1
                            ? "no measured quantity depends on it"
                            : fmt::format("the data determine only a combination of it and {}",
                                          others(flat, i, parameters)));
  }
  if (!p.remarks.empty()) return p;  // other remarks do not apply
  remark(range, position, p);
  if (elsewhere) p.remarks.push_back("values far from the best one fit as well");
  return p;
}

/// Adds remarks on strongly correlated parameters. Those in flat directions already have a remark.
void remark_correlation(LeastSquaresResult& fit, const Curvature& curvature) {
  constexpr double close = 0.98;
  std::vector<bool> flat(fit.parameters.size(), false);
  for (const std::vector<std::size_t>& direction : curvature.flat)
    for (const std::size_t i : direction) flat[i] = true;
  for (std::size_t i = 0; i < flat.size(); ++i)
    for (std::size_t k = 0; k < flat.size(); ++k)
      if (const double c = fit.correlation[i][k];
          i != k && !flat[i] && !flat[k] && std::abs(c) > close)
        fit.parameters[i].remarks.push_back(fmt::format(
            "hard to distinguish from {}: their correlation is {:.4f}", fit.parameters[k].name, c));
}

void remark_all(LeastSquaresResult& fit, ErrorScale scatter) {
  const auto count = fit.residuals.size();
  if (fit.degrees_of_freedom < 0)
    fit.remarks.push_back(fmt::format("fewer measured values than parameters: {} and {}", count,
                                      fit.parameters.size()));
  if (fit.degrees_of_freedom == 0 && scatter == ErrorScale::estimated)
    fit.remarks.push_back(
        "as many measured values as parameters: there is no degree of freedom to estimate their "
        "scatter, and no interval can be given");
  if (scatter == ErrorScale::known && fit.degrees_of_freedom > 0 &&
      fit.sum_of_squares > fit.degrees_of_freedom + 3 * std::sqrt(2.0 * fit.degrees_of_freedom))
    fit.remarks.push_back(
        fmt::format("the data lie {:.2g} times as far from the fit as their errors say: the errors "
                    "are too small, or the model does not fit; the intervals allow for it",
                    fit.scatter));
}

}  // namespace

std::string FittedParameter::interval_text() const {
  if (!determined) return "not determined";
  if (open_low) return "up to " + text.high;
  if (open_high) return text.low + " or more";
  return text.low + " to " + text.high;
}

bool ParameterEstimates::all_determined() const {
  return std::ranges::all_of(parameters, &FittedParameter::determined);
}

LeastSquaresResult least_squares(const Residuals& residuals,
                                 const std::vector<FreeParameter>& parameters, ErrorScale scatter) {
  if (parameters.empty()) throw std::invalid_argument("no parameter to fit");
  for (const FreeParameter& p : parameters)
    if (!std::isfinite(p.least) || !std::isfinite(p.most) || !(p.least < p.most))
      throw std::invalid_argument("the range of " + p.name + " is not an interval");
  Minimiser search(residuals, parameters);
  const BestFit best = find_best_fit(search, scatter);
  LeastSquaresResult fit;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    fit.parameters.push_back(fitted(best, search, parameters, i));
  fit.correlation = correlation(best.curvature.covariance);
  fit.residuals = best.best.residuals;
  fit.sum_of_squares = best.best.sum;
  fit.degrees_of_freedom =
      static_cast<int>(fit.residuals.size()) - static_cast<int>(parameters.size());
  fit.scatter = fit.degrees_of_freedom > 0 ? std::sqrt(fit.sum_of_squares / fit.degrees_of_freedom)
                                           : std::numeric_limits<double>::quiet_NaN();  // (fit.3)
  fit.evaluations = static_cast<int>(search.evaluations().size());
  remark_correlation(fit, best.curvature);
  remark_all(fit, scatter);
  return fit;
}

}  // namespace mahlwerk::campaign
