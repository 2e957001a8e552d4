// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/minimiser.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <nlopt.hpp>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/error.hpp"

namespace mahlwerk::campaign {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

VectorXd vector(const std::vector<double>& v) {
  return Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size()));
}

/// The n-th point of the van der Corput sequence in 0 ... 1.
double van_der_corput(int n, int base) {
  double position = 0, digit = 1;
  for (; n > 0; n /= base) position += (digit /= base) * (n % base);
  return position;
}

double steepness(const std::vector<double>& slope, const Evaluation& at) {
  double sum = 0;
  for (std::size_t k = 0; k < slope.size(); ++k) sum -= slope[k] * at.residuals[k];
  return sum;
}

/// Decrease of the sum that is not worth a step: far less than the rise that intervals allow
/// (fit.4).
double negligible_decrease(const Evaluation& at) {
  return 1e-4 * at.sum / static_cast<double>(at.residuals.size());
}

/// Callback of NLopt. NLopt does not pass on exceptions of other libraries: the callback keeps
/// them.
struct LocalSearch {
  Minimiser& search;
  Evaluation best;
  std::exception_ptr thrown;

  static double step(const std::vector<double>& position, std::vector<double>&, void* data) {
    LocalSearch& self = *static_cast<LocalSearch*>(data);
    try {
      Evaluation point = self.search.evaluate(position);
      const double sum = point.sum;
      if (sum < self.best.sum) self.best = std::move(point);
      return sum;
    } catch (...) {
      self.thrown = std::current_exception();
      throw nlopt::forced_stop();
    }
  }
};

}  // namespace

double value_at(const FreeParameter& p, double position) {
  if (position <= 0) return p.least;
  if (position >= 1) return p.most;
  if (!p.logarithmic()) return p.least + (p.most - p.least) * position;
  const double least = math::log(p.least);  // (fit.2), without overflow for wide ranges
  return math::exp(least + (math::log(p.most) - least) * position);
}

double position_of(const FreeParameter& p, double value) {
  const double position = p.logarithmic() ? (math::log(value) - math::log(p.least)) /
                                                (math::log(p.most) - math::log(p.least))
                                          : (value - p.least) / (p.most - p.least);
  return std::clamp(position, 0.0, 1.0);
}

Evaluation Minimiser::evaluate(const std::vector<double>& position) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count(); ++i) values.push_back(value_at(parameters_[i], position[i]));
  Evaluation point{.position = position, .residuals = residuals_(values)};
  double sum = 0;
  for (const double r : point.residuals) sum += r * r;  // (fit.1)
  if (std::isfinite(sum)) point.sum = sum;
  evaluations_.push_back({position, {}, point.sum});
  return point;
}

std::vector<std::vector<double>> Minimiser::slopes(const Evaluation& at, bool fine,
                                                   std::optional<std::size_t> fixed) {
  constexpr double step = 1e-4;
  std::vector<std::vector<double>> made;
  for (std::size_t i = 0; i < count(); ++i) {
    std::vector<Evaluation> beside;
    for (const double way : {step, -step}) {
      std::vector<double> position = at.position;
      position[i] += way;
      if (i == fixed || position[i] < 0 || position[i] > 1 || (!fine && !beside.empty())) continue;
      if (Evaluation point = evaluate(position); std::isfinite(point.sum))
        beside.push_back(std::move(point));
    }
    std::vector<double>& slope = made.emplace_back(at.residuals.size(), 0);
    if (beside.empty()) continue;
    const Evaluation &to = beside.front(), &from = beside.size() > 1 ? beside.back() : at;
    for (std::size_t k = 0; k < slope.size(); ++k)
      slope[k] = (to.residuals[k] - from.residuals[k]) / (to.position[i] - from.position[i]);
  }
  return made;
}

Evaluation Minimiser::levenberg_marquardt(Evaluation at, std::optional<std::size_t> fixed) {
  constexpr int max_rounds = 50;
  double damping = 1e-3;
  for (int round = 0; round < max_rounds && std::isfinite(at.sum); ++round) {
    std::vector<std::vector<double>> slope = slopes(at, false, fixed);
    for (std::size_t i = 0; i < count(); ++i) {
      const double down = steepness(slope[i], at);
      if ((at.position[i] <= 0 && down < 0) || (at.position[i] >= 1 && down > 0))
        slope[i].assign(slope[i].size(), 0);
    }
    std::optional<Evaluation> next = damped_step(at, slope, damping);
    if (!next) break;
    const bool enough = at.sum - next->sum < negligible_decrease(at);
    at = std::move(*next);
    if (enough) break;
  }
  return at;
}

/// The first lower position found as the damping grows; empty at a minimum.
std::optional<Evaluation> Minimiser::damped_step(const Evaluation& at,
                                                 const std::vector<std::vector<double>>& slopes,
                                                 double& damping) {
  constexpr double least = 1e-9, most = 1e9, shortest = 1e-13;
  MatrixXd slope(at.residuals.size(), count());
  for (std::size_t i = 0; i < count(); ++i) slope.col(static_cast<Index>(i)) = vector(slopes[i]);
  const VectorXd steepest = -slope.transpose() * vector(at.residuals);
  const MatrixXd square = slope.transpose() * slope;
  const VectorXd sizes = square.diagonal();
  const double largest = sizes.maxCoeff();
  if (!(largest > 0)) return std::nullopt;
  for (; damping < most; damping *= 10) {
    MatrixXd damped = square;
    for (Index i = 0; i < sizes.size(); ++i)
      damped(i, i) += sizes(i) > 0 ? damping * sizes(i) + 1e-15 * largest : largest;
    const VectorXd step = damped.ldlt().solve(steepest);
    if (step.norm() < shortest || step.dot(steepest) < negligible_decrease(at)) return std::nullopt;
    std::vector<double> position = at.position;
    for (std::size_t i = 0; i < count(); ++i)
      position[i] = std::clamp(position[i] + step(static_cast<Index>(i)), 0.0, 1.0);
    Evaluation next = evaluate(position);
    if (next.sum < at.sum) {
      damping = std::max(least, damping / 10);
      return next;
    }
  }
  return std::nullopt;
}

Evaluation Minimiser::subplex_search(const Evaluation& from) {
  const auto n = static_cast<unsigned>(count());
  nlopt::opt subplex(nlopt::LN_SBPLX, n);
  subplex.set_lower_bounds(0);
  subplex.set_upper_bounds(1);
  subplex.set_initial_step(0.1);
  subplex.set_ftol_rel(1e-3);
  subplex.set_xtol_abs(1e-4);
  subplex.set_maxeval(25 * static_cast<int>(n + 1));
  LocalSearch local_search{*this, from, {}};
  subplex.set_min_objective(LocalSearch::step, &local_search);
  std::vector<double> position = from.position;
  double sum = 0;
  try {
    subplex.optimize(position, sum);
  } catch (const nlopt::roundoff_limited&) {  // limited by rounding: keeps the best point
  } catch (const nlopt::forced_stop&) {
    std::rethrow_exception(local_search.thrown);
  }
  return local_search.best;
}

std::vector<Evaluation> Minimiser::start_points() {
  constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  constexpr std::size_t most = 3;
  constexpr double apart = 0.15;
  std::vector<double> position;
  for (const FreeParameter& p : parameters_)
    position.push_back(p.start ? position_of(p, *p.start) : 0.5);
  std::vector<Evaluation> all{evaluate(position)}, best;
  for (int n = 1; n <= 15 * static_cast<int>(count() + 1); ++n) {
    for (std::size_t i = 0; i < count(); ++i)  // primes are reused with an offset
      position[i] =
          van_der_corput(n + static_cast<int>(i / primes.size()), primes[i % primes.size()]);
    all.push_back(evaluate(position));
  }
  std::ranges::stable_sort(all, {}, &Evaluation::sum);
  const auto far = [](const Evaluation& a, const Evaluation& b) {
    double way = 0;
    for (std::size_t i = 0; i < a.position.size(); ++i)
      way = std::max(way, std::abs(a.position[i] - b.position[i]));
    return way > apart;
  };
  for (const Evaluation& point : all)
    if (best.size() < most && std::isfinite(point.sum) &&
        std::ranges::all_of(best, [&](const Evaluation& other) { return far(point, other); }))
      best.push_back(point);
  if (best.empty()) throw RunError("no set of parameters tried within their ranges gives a result");
  return best;
}

}  // namespace mahlwerk::campaign
