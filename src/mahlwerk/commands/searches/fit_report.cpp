// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/commands/searches/fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::commands {
namespace {

using campaign::MeasuredQuantity, campaign::Measurement;
using report::FitCurve, report::FitParameter, report::FitPoint, report::FitReport;

FitParameter number(const cases::FitParameter& of, const campaign::FreeParameter& range,
                    const campaign::FittedParameter& found, double simulation_ci95) {
  return {.key = of.key,
          .unit = of.unit,
          .about = of.about,
          .value = found.value,
          .low = found.low,
          .high = found.high,
          .simulation_ci95 = simulation_ci95,
          .least = range.least,
          .most = range.most,
          .open_low = found.open_low,
          .open_high = found.open_high,
          .determined = found.determined,
          .remarks = found.remarks};
}

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

std::vector<FitCurve> curves(const campaign::FitJob& job,
                             const std::vector<results::Outcome>& mills,
                             const campaign::LeastSquaresResult& found) {
  CurveRequests requests = curve_requests(job.data.values);
  std::vector<double> values;
  for (const campaign::FittedParameter& p : found.parameters) values.push_back(p.value);
  const std::vector<double> predicted =
      campaign::Predictor(mills, job.parameters, std::move(requests.measurements))(values);
  auto next = predicted.begin();
  for (FitCurve& curve : requests.curves) {
    const auto end = next + static_cast<std::ptrdiff_t>(curve.x.size());
    curve.y.assign(next, end);
    next = end;
  }
  return std::move(requests.curves);
}

FitPoint point(const Measurement& m, double predicted) {
  return {.what = name_of(m.what, m.percent),
          .unit = std::string(unit_of(m.what)),
          .condition = m.condition,
          .time = m.time,
          .size = m.size,
          .measured = m.value,
          .error = m.error,
          .fitted = predicted,
          .residual = campaign::residual(m, predicted),
          .line = m.line};
}

}  // namespace

std::string condition_label(const std::vector<cases::Override>& condition) {
  std::string text;
  for (const cases::Override& set : condition)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", set.key, set.value);
  return text;
}

FitReport fit_report(const campaign::FitJob& job, const std::vector<results::Outcome>& mills,
                     const campaign::Fit& fit) {
  FitReport made{.title = job.base.title,
                 .case_file = job.base.file,
                 .data_file = job.data_file,
                 .correlation = fit.result.correlation,
                 .curves = curves(job, mills, fit.result),
                 .remarks = fit.result.remarks,
                 .scatter = fit.result.scatter,
                 .degrees_of_freedom = fit.result.degrees_of_freedom,
                 .evaluations = fit.result.evaluations,
                 .errors_known = job.data.errors_known()};
  const std::vector<cases::FitParameter> known = cases::fit_parameters(job.base);
  for (std::size_t i = 0; i < job.parameters.size(); ++i)
    made.parameters.push_back(
        number(*std::ranges::find(known, job.parameters[i].name, &cases::FitParameter::key),
               job.parameters[i], fit.result.parameters[i], fit.simulation_ci95[i]));
  for (const auto& condition : job.data.conditions)
    made.conditions.push_back(condition_label(condition));
  for (std::size_t i = 0; i < job.data.values.size(); ++i)
    made.points.push_back(point(job.data.values[i], fit.predicted[i]));
  for (const results::Outcome& mill : mills) results::count(made.notices, mill.notices);
  results::sort(made.notices);
  if (std::ranges::any_of(fit.simulation_ci95, [](double width) { return std::isnan(width); }))
    made.remarks.push_back(
        "the mill ran one replicate: the contribution of its scatter to the intervals is not "
        "known");
  return made;
}

results::Json fit_json(const FitReport& fit, std::string_view version) {
  using results::Json;
  Json numbers = Json::object();
  for (const FitParameter& n : fit.parameters)
    numbers[n.key] = Json::object({{"value", n.value},
                                   {"low", n.open_low ? Json() : n.low},
                                   {"high", n.open_high ? Json() : n.high},
                                   {"unit", n.unit},
                                   {"determined", n.determined},
                                   {"by_mills", n.simulation_ci95},
                                   {"range", Json::array({n.least, n.most})},
                                   {"remarks", n.remarks},
                                   {"about", n.about}});
  return Json::object({{"mahlwerk", version},
                       {"title", fit.title},
                       {"case", fit.case_file},
                       {"data", fit.data_file},
                       {"all_determined", fit.all_determined()},
                       {"numbers", std::move(numbers)},
                       {"correlation", fit.correlation},
                       {"conditions", fit.conditions},
                       {"values", fit.points.size()},
                       {"freedom", fit.degrees_of_freedom},
                       {"scatter", fit.scatter},
                       {"errors_known", fit.errors_known},
                       {"evaluations", fit.evaluations},
                       {"remarks", fit.remarks},
                       {"notices", results::notices_json(fit.notices)}});
}

cases::Case fitted_case(const campaign::FitJob& job, const FitReport& fit) {
  cases::Case mill_case = job.base;
  mill_case.fit.clear();
  for (const FitParameter& n : fit.parameters) {
    cases::set_fit_parameter(mill_case, n.key, n.value);
    for (cases::Origin& origin : mill_case.origins)
      if (origin.key == n.key) {
        origin.value = n.unit.empty() ? shortest(n.value) : show(n.value, n.unit);
        origin.source = fmt::format("fitted to {}: {}", fit.data_file,
                                    n.determined ? n.interval_text() : "not determined by it");
      }
  }
  return mill_case;
}

}  // namespace mahlwerk::commands
