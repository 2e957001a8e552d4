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

using Place = std::vector<double>;

/// What NLopt calls back. It would not let exceptions of others through.
struct Looking {
  const std::function<double(const Place&)>& function;
  const Place &least, &most;
  Highest best = {{}, -std::numeric_limits<double>::infinity()};
  std::exception_ptr thrown = {};

  double look(Place place) {
    constexpr double lowest = -1e300;               // NLopt stops at what is not finite
    for (std::size_t i = 0; i < place.size(); ++i)  // NLopt leaves the box by rounding
      place[i] = std::clamp(place[i], least[i], most[i]);
    const double value = function(place);
    if (value > best.value || best.place.empty()) best = {std::move(place), value};
    return std::isfinite(value) ? value : lowest;
  }
  static double step(const Place& place, Place&, void* data) {
    Looking& self = *static_cast<Looking*>(data);
    try {
      return self.look(place);
    } catch (...) {
      self.thrown = std::current_exception();
      throw nlopt::forced_stop();
    }
  }
  void search(nlopt::opt& by, Place from) {
    double value = 0;
    by.set_max_objective(step, this);
    try {
      by.optimize(from, value);
    } catch (const nlopt::roundoff_limited&) {  // as high as it gets
    } catch (const nlopt::forced_stop&) {
      std::rethrow_exception(thrown);
    }
  }
};

nlopt::opt bounded(nlopt::algorithm how, const Place& least, const Place& most, int evaluations) {
  nlopt::opt by(how, static_cast<unsigned>(least.size()));
  by.set_lower_bounds(least);
  by.set_upper_bounds(most);
  by.set_maxeval(evaluations);
  return by;
}

}  // namespace

Highest highest(const std::function<double(const Place&)>& function, const Place& least,
                const Place& most, const std::vector<Place>& starts, const Effort& effort) {
  constexpr double first_step = 0.05, fine = 1e-4;  // of the box
  Looking looking{function, least, most};
  std::vector<Place> from = starts;
  for (const Place& place : starts) looking.look(place);
  if (effort.wide > 0) {
    Place middle;
    for (std::size_t i = 0; i < least.size(); ++i) middle.push_back((least[i] + most[i]) / 2);
    Looking wide{function, least, most};
    nlopt::opt by = bounded(nlopt::GN_DIRECT_L, least, most, effort.wide);
    wide.search(by, middle);
    from.push_back(wide.best.place);
    if (wide.best.value > looking.best.value) looking.best = wide.best;
  }
  if (effort.near > 0)
    for (const Place& place : from) {
      nlopt::opt by = bounded(nlopt::LN_SBPLX, least, most, effort.near);
      Place step, tolerance;
      for (std::size_t i = 0; i < least.size(); ++i) {
        step.push_back(first_step * (most[i] - least[i]));
        tolerance.push_back(fine * (most[i] - least[i]));
      }
      by.set_initial_step(step);
      by.set_xtol_abs(tolerance);
      looking.search(by, place);
    }
  return looking.best;
}

}  // namespace mahlwerk::campaign
