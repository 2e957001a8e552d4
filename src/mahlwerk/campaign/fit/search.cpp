// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/search.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <nlopt.hpp>

#include "mahlwerk/base/error.hpp"

namespace mahlwerk::campaign {
namespace {

using Eigen::Index, Eigen::MatrixXd, Eigen::VectorXd;

VectorXd vector(const std::vector<double>& v) {
  return Eigen::Map<const VectorXd>(v.data(), static_cast<Index>(v.size()));
}

/// The n-th of points that fill 0 ... 1 ever more evenly (van der Corput).
double evenly(int n, int base) {
  double place = 0, digit = 1;
  for (; n > 0; n /= base) place += (digit /= base) * (n % base);
  return place;
}

double steepness(const std::vector<double>& slope, const Point& at) {
  double sum = 0;
  for (std::size_t k = 0; k < slope.size(); ++k) sum -= slope[k] * at.residuals[k];
  return sum;
}

/// What is not worth a step: far less than the rise that intervals allow (fit.4).
double worthless(const Point& at) {
  return 1e-4 * at.sum / static_cast<double>(at.residuals.size());
}

/// What NLopt calls back. It would not let exceptions of others through.
struct Roaming {
  Search& search;
  Point best;
  std::exception_ptr thrown;

  static double step(const std::vector<double>& place, std::vector<double>&, void* data) {
    Roaming& self = *static_cast<Roaming*>(data);
    try {
      Point point = self.search.look(place);
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

double value_at(const FreeParameter& p, double place) {
  if (place <= 0) return p.least;
  if (place >= 1) return p.most;
  if (!p.logarithmic()) return p.least + (p.most - p.least) * place;
  const double least = std::log(p.least);  // (fit.2), of ranges of any width
  return std::exp(least + (std::log(p.most) - least) * place);
}

double place_of(const FreeParameter& p, double value) {
  const double place = p.logarithmic() ? (std::log(value) - std::log(p.least)) /
                                             (std::log(p.most) - std::log(p.least))
                                       : (value - p.least) / (p.most - p.least);
  return std::clamp(place, 0.0, 1.0);
}

Point Search::look(const std::vector<double>& place) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count(); ++i) values.push_back(value_at(parameters_[i], place[i]));
  Point point{.place = place, .residuals = residuals_(values)};
  double sum = 0;
  for (const double r : point.residuals) sum += r * r;  // (fit.1)
  if (std::isfinite(sum)) point.sum = sum;
  seen_.push_back({place, {}, point.sum});
  return point;
}

std::vector<std::vector<double>> Search::slopes(const Point& at, bool fine,
                                                std::optional<std::size_t> held) {
  constexpr double step = 1e-4;
  std::vector<std::vector<double>> made;
  for (std::size_t i = 0; i < count(); ++i) {
    std::vector<Point> beside;
    for (const double way : {step, -step}) {
      std::vector<double> place = at.place;
      place[i] += way;
      if (i == held || place[i] < 0 || place[i] > 1 || (!fine && !beside.empty())) continue;
      if (Point point = look(place); std::isfinite(point.sum)) beside.push_back(std::move(point));
    }
    std::vector<double>& slope = made.emplace_back(at.residuals.size(), 0);
    if (beside.empty()) continue;
    const Point &to = beside.front(), &from = beside.size() > 1 ? beside.back() : at;
    for (std::size_t k = 0; k < slope.size(); ++k)
      slope[k] = (to.residuals[k] - from.residuals[k]) / (to.place[i] - from.place[i]);
  }
  return made;
}

Point Search::descend(Point at, std::optional<std::size_t> held) {
  constexpr int most_rounds = 50;
  double damping = 1e-3;
  for (int round = 0; round < most_rounds && std::isfinite(at.sum); ++round) {
    std::vector<std::vector<double>> slope = slopes(at, false, held);
    for (std::size_t i = 0; i < count(); ++i) {
      const double down = steepness(slope[i], at);
      if ((at.place[i] <= 0 && down < 0) || (at.place[i] >= 1 && down > 0))
        slope[i].assign(slope[i].size(), 0);
    }
    std::optional<Point> next = lower(at, slope, damping);
    if (!next) break;
    const bool enough = at.sum - next->sum < worthless(at);
    at = std::move(*next);
    if (enough) break;
  }
  return at;
}

/// The first lower place found by ever shorter steps; nothing where the bottom is reached.
std::optional<Point> Search::lower(const Point& at, const std::vector<std::vector<double>>& slopes,
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
    if (step.norm() < shortest || step.dot(steepest) < worthless(at)) return std::nullopt;
    std::vector<double> place = at.place;
    for (std::size_t i = 0; i < count(); ++i)
      place[i] = std::clamp(place[i] + step(static_cast<Index>(i)), 0.0, 1.0);
    Point next = look(place);
    if (next.sum < at.sum) {
      damping = std::max(least, damping / 10);
      return next;
    }
  }
  return std::nullopt;
}

Point Search::roam(const Point& from) {
  const auto n = static_cast<unsigned>(count());
  nlopt::opt subplex(nlopt::LN_SBPLX, n);
  subplex.set_lower_bounds(0);
  subplex.set_upper_bounds(1);
  subplex.set_initial_step(0.1);
  subplex.set_ftol_rel(1e-3);
  subplex.set_xtol_abs(1e-4);
  subplex.set_maxeval(25 * static_cast<int>(n + 1));
  Roaming roaming{*this, from, {}};
  subplex.set_min_objective(Roaming::step, &roaming);
  std::vector<double> place = from.place;
  double sum = 0;
  try {
    subplex.optimize(place, sum);
  } catch (const nlopt::roundoff_limited&) {  // as low as it gets
  } catch (const nlopt::forced_stop&) {
    std::rethrow_exception(roaming.thrown);
  }
  return roaming.best;
}

std::vector<Point> Search::starts() {
  constexpr std::array primes{2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
  constexpr std::size_t most = 3;
  constexpr double apart = 0.15;
  std::vector<double> place;
  for (const FreeParameter& p : parameters_) place.push_back(p.start ? place_of(p, *p.start) : 0.5);
  std::vector<Point> all{look(place)}, best;
  for (int n = 1; n <= 15 * static_cast<int>(count() + 1); ++n) {
    for (std::size_t i = 0; i < count(); ++i)  // beyond the primes, the same again, shifted
      place[i] = evenly(n + static_cast<int>(i / primes.size()), primes[i % primes.size()]);
    all.push_back(look(place));
  }
  std::ranges::stable_sort(all, {}, &Point::sum);
  const auto far = [](const Point& a, const Point& b) {
    double way = 0;
    for (std::size_t i = 0; i < a.place.size(); ++i)
      way = std::max(way, std::abs(a.place[i] - b.place[i]));
    return way > apart;
  };
  for (const Point& point : all)
    if (best.size() < most && std::isfinite(point.sum) &&
        std::ranges::all_of(best, [&](const Point& other) { return far(point, other); }))
      best.push_back(point);
  if (best.empty())
    throw RunError("none of the sets of parameters tried in their ranges gives a result");
  return best;
}

}  // namespace mahlwerk::campaign
