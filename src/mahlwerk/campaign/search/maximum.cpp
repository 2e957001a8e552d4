// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/search/maximum.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>
#include <nlopt.hpp>
#include <utility>

namespace mahlwerk::campaign {
namespace {

using Position = std::vector<double>;

/// Callback of NLopt. NLopt does not pass on exceptions of other libraries: the callback keeps
/// them.
struct NloptCallback {
  const std::function<double(const Position&)>& function;
  const Position &least, &most;
  Maximum best = {{}, -std::numeric_limits<double>::infinity()};
  std::exception_ptr thrown = {};

  double evaluate(Position point) {
    constexpr double lowest = -1e300;               // NLopt stops at values that are not finite
    for (std::size_t i = 0; i < point.size(); ++i)  // NLopt leaves the box by rounding
      point[i] = std::clamp(point[i], least[i], most[i]);
    const double value = function(point);
    if (value > best.value || best.point.empty()) best = {std::move(point), value};
    return std::isfinite(value) ? value : lowest;
  }
  static double step(const Position& point, Position&, void* data) {
    NloptCallback& self = *static_cast<NloptCallback*>(data);
    try {
      return self.evaluate(point);
    } catch (...) {
      self.thrown = std::current_exception();
      throw nlopt::forced_stop();
    }
  }
  void search(nlopt::opt& by, Position from) {
    double value = 0;
    by.set_max_objective(step, this);
    try {
      by.optimize(from, value);
    } catch (const nlopt::roundoff_limited&) {  // limited by rounding: keeps the best point
    } catch (const nlopt::forced_stop&) {
      std::rethrow_exception(thrown);
    }
  }
};

nlopt::opt bounded_optimiser(nlopt::algorithm how, const Position& least, const Position& most,
                             int evaluations) {
  nlopt::opt by(how, static_cast<unsigned>(least.size()));
  by.set_lower_bounds(least);
  by.set_upper_bounds(most);
  by.set_maxeval(evaluations);
  return by;
}

}  // namespace

Maximum find_maximum(const std::function<double(const Position&)>& function, const Position& least,
                     const Position& most, const std::vector<Position>& starts,
                     const EvaluationBudget& budget) {
  constexpr double first_step = 0.05, fine = 1e-4;  // relative to the box
  NloptCallback callback{function, least, most};
  std::vector<Position> from = starts;
  for (const Position& point : starts) callback.evaluate(point);
  if (budget.global > 0) {
    Position middle;
    for (std::size_t i = 0; i < least.size(); ++i) middle.push_back((least[i] + most[i]) / 2);
    NloptCallback wide{function, least, most};
    nlopt::opt by = bounded_optimiser(nlopt::GN_DIRECT_L, least, most, budget.global);
    wide.search(by, middle);
    from.push_back(wide.best.point);
    if (wide.best.value > callback.best.value) callback.best = wide.best;
  }
  if (budget.local > 0)
    for (const Position& point : from) {
      nlopt::opt by = bounded_optimiser(nlopt::LN_SBPLX, least, most, budget.local);
      Position step, tolerance;
      for (std::size_t i = 0; i < least.size(); ++i) {
        step.push_back(first_step * (most[i] - least[i]));
        tolerance.push_back(fine * (most[i] - least[i]));
      }
      by.set_initial_step(step);
      by.set_xtol_abs(tolerance);
      callback.search(by, point);
    }
  return callback.best;
}

}  // namespace mahlwerk::campaign
