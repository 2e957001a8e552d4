// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0

// The fit of a case and its measurements, with curves of the model.
#include <fmt/format.h>

#include <algorithm>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/fit/job.hpp"
#include "mahlwerk/cases/grinding.hpp"

namespace mahlwerk::campaign {
namespace {

/// Curves without y values, and the measurements whose model predictions fill them.
struct CurveRequests {
  std::vector<FitCurve> curves;
  std::vector<Measurement> measurements;  ///< of all curves, in their order
};

/// A curve over time, from 0 to the longest time of this measurement.
void request_over_time(const std::vector<Measurement>& data, const Measurement& m,
                       CurveRequests& requests) {
  constexpr int steps = 100;
  double longest = 0;
  for (const Measurement& other : data)
    if (other.condition == m.condition && other.what == m.what && other.percent == m.percent)
      longest = std::max(longest, other.time);
  FitCurve curve{name_of(m.what, m.percent), m.condition, 0, {}, {}};
  Measurement question = m;
  for (int i = 0; i <= steps; ++i) {
    question.time = longest * i / steps;
    curve.x.push_back(question.time);
    requests.measurements.push_back(question);
  }
  requests.curves.push_back(std::move(curve));
}

/// A curve over sizes, extended by a factor of 1.5 beyond the measured ones.
void request_over_size(const std::vector<Measurement>& data, const Measurement& m,
                       CurveRequests& requests) {
  constexpr int steps = 100;
  constexpr double beyond = 1.5;
  double least = m.size, most = m.size;
  for (const Measurement& other : data)
    if (other.condition == m.condition && other.what == m.what && other.time == m.time) {
      least = std::min(least, other.size);
      most = std::max(most, other.size);
    }
  FitCurve curve{name_of(m.what, 0), m.condition, m.time, {}, {}};
  Measurement question = m;
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    question.size = least / beyond * math::pow(most / least * beyond * beyond, share);
    curve.x.push_back(question.size);
    requests.measurements.push_back(question);
  }
  requests.curves.push_back(std::move(curve));
}

CurveRequests curve_requests(const std::vector<Measurement>& data) {
  CurveRequests requests;
  for (const Measurement& m : data) {
    const bool sizes = m.what == MeasuredQuantity::passing;
    const bool known = std::ranges::any_of(requests.curves, [&](const FitCurve& c) {
      return c.what == name_of(m.what, m.percent) && c.condition == m.condition &&
             (!sizes || c.time == m.time);
    });
    if (known) continue;
    if (sizes)
      request_over_size(data, m, requests);
    else
      request_over_time(data, m, requests);
  }
  return requests;
}

std::vector<FitCurve> curves(const FitJob& job, const std::vector<results::Outcome>& mills,
                             const LeastSquaresResult& found) {
  CurveRequests requests = curve_requests(job.data.values);
  std::vector<double> values;
  for (const FittedParameter& p : found.parameters) values.push_back(p.value);
  const std::vector<double> predicted =
      Predictor(mills, job.parameters, std::move(requests.measurements))(values);
  auto next = predicted.begin();
  for (FitCurve& curve : requests.curves) {
    const auto end = next + static_cast<std::ptrdiff_t>(curve.x.size());
    curve.y.assign(next, end);
    next = end;
  }
  return std::move(requests.curves);
}

}  // namespace

Fit fit(const FitJob& job, const std::vector<results::Outcome>& mills, const FitOptions& options) {
  Fit made = fit(mills, job.data, job.parameters, options);
  describe(made, job.base, job.data_file, job.data);
  made.curves = curves(job, mills, made.result);
  return made;
}

cases::Case fitted_case(const FitJob& job, const Fit& found) {
  cases::Case mill_case = job.base;
  mill_case.fit.clear();
  for (const FittedParameter& p : found.result.parameters) {
    cases::set_fit_parameter(mill_case, p.name, p.value);
    for (cases::Origin& origin : mill_case.origins)
      if (origin.key == p.name) {
        origin.value = p.unit.empty() ? shortest(p.value) : show(p.value, p.unit);
        origin.source = fmt::format("fitted to {}: {}", found.data_file,
                                    p.determined ? p.interval_text() : "not determined by it");
      }
  }
  return mill_case;
}

}  // namespace mahlwerk::campaign
