// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "fit_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "mahlwerk/base/units.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::app {
namespace {

using campaign::Measured, campaign::Measurement;
using report::FitCurve, report::FitNumber, report::FitPoint, report::FitReport;

std::string label(const std::vector<cases::Override>& condition) {
  std::string text;
  for (const cases::Override& set : condition)
    text += fmt::format("{}{} = {}", text.empty() ? "" : ", ", set.key, set.value);
  return text;
}

FitNumber number(const cases::Adjustable& of, const campaign::FreeParameter& range,
                 const campaign::FittedParameter& found, double by_mills) {
  return {.key = of.key,
          .unit = of.unit,
          .about = of.about,
          .value = found.value,
          .low = found.low,
          .high = found.high,
          .by_mills = by_mills,
          .least = range.least,
          .most = range.most,
          .open_low = found.open_low,
          .open_high = found.open_high,
          .determined = found.determined,
          .remarks = found.remarks};
}

/// Curves that hold places for what the models will say, and what to ask them.
struct Asked {
  std::vector<FitCurve> curves;
  std::vector<Measurement> questions;  ///< of one curve after the other
};

/// Over time, from none to the longest that this was measured after.
void ask_over_time(const std::vector<Measurement>& data, const Measurement& m, Asked& asked) {
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
    asked.questions.push_back(question);
  }
  asked.curves.push_back(std::move(curve));
}

/// Over sizes, somewhat beyond those where this distribution was measured.
void ask_over_size(const std::vector<Measurement>& data, const Measurement& m, Asked& asked) {
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
    question.size = least / beyond * std::pow(most / least * beyond * beyond, share);
    curve.x.push_back(question.size);
    asked.questions.push_back(question);
  }
  asked.curves.push_back(std::move(curve));
}

Asked ask(const std::vector<Measurement>& data) {
  Asked asked;
  for (const Measurement& m : data) {
    const bool sizes = m.what == Measured::passing;
    const bool known = std::ranges::any_of(asked.curves, [&](const FitCurve& c) {
      return c.what == name_of(m.what, m.percent) && c.condition == m.condition &&
             (!sizes || c.time == m.time);
    });
    if (known) continue;
    if (sizes)
      ask_over_size(data, m, asked);
    else
      ask_over_time(data, m, asked);
  }
  return asked;
}

std::vector<FitCurve> curves(const campaign::FitJob& job,
                             const std::vector<results::Outcome>& mills,
                             const campaign::Fitted& found) {
  Asked asked = ask(job.data.values);
  std::vector<double> values;
  for (const campaign::FittedParameter& p : found.parameters) values.push_back(p.value);
  const std::vector<double> told =
      campaign::Predictor(mills, job.numbers, std::move(asked.questions))(values);
  auto next = told.begin();
  for (FitCurve& curve : asked.curves) {
    const auto end = next + static_cast<std::ptrdiff_t>(curve.x.size());
    curve.y.assign(next, end);
    next = end;
  }
  return std::move(asked.curves);
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

FitReport fit_report(const campaign::FitJob& job, const std::vector<results::Outcome>& mills,
                     const campaign::Fit& fit) {
  FitReport made{.title = job.base.title,
                 .case_file = job.base.file,
                 .data_file = job.data_file,
                 .correlation = fit.found.correlation,
                 .curves = curves(job, mills, fit.found),
                 .remarks = fit.found.remarks,
                 .scatter = fit.found.scatter,
                 .freedom = fit.found.freedom,
                 .evaluations = fit.found.evaluations,
                 .errors_known = job.data.errors_known()};
  const std::vector<cases::Adjustable> known = cases::adjustables(job.base);
  for (std::size_t i = 0; i < job.numbers.size(); ++i)
    made.numbers.push_back(
        number(*std::ranges::find(known, job.numbers[i].name, &cases::Adjustable::key),
               job.numbers[i], fit.found.parameters[i], fit.by_mills[i]));
  for (const auto& condition : job.data.conditions) made.conditions.push_back(label(condition));
  for (std::size_t i = 0; i < job.data.values.size(); ++i)
    made.points.push_back(point(job.data.values[i], fit.predicted[i]));
  for (const results::Outcome& mill : mills) results::count(made.notices, mill.notices);
  results::sort(made.notices);
  if (std::ranges::any_of(fit.by_mills, [](double width) { return std::isnan(width); }))
    made.remarks.push_back(
        "the mill ran one replicate: what its scatter adds to the intervals is not known");
  return made;
}

results::Json fit_json(const FitReport& fit, std::string_view version) {
  using results::Json;
  Json numbers = Json::object();
  for (const FitNumber& n : fit.numbers)
    numbers[n.key] = Json::object({{"value", n.value},
                                   {"low", n.open_low ? Json() : n.low},
                                   {"high", n.open_high ? Json() : n.high},
                                   {"unit", n.unit},
                                   {"determined", n.determined},
                                   {"by_mills", n.by_mills},
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
                       {"freedom", fit.freedom},
                       {"scatter", fit.scatter},
                       {"errors_known", fit.errors_known},
                       {"evaluations", fit.evaluations},
                       {"remarks", fit.remarks},
                       {"notices", results::notices_json(fit.notices)}});
}

cases::Case fitted_case(const campaign::FitJob& job, const FitReport& fit) {
  cases::Case what = job.base;
  what.fit.clear();
  for (const FitNumber& n : fit.numbers) {
    cases::adjust(what, n.key, n.value);
    for (cases::Origin& origin : what.origins)
      if (origin.key == n.key) {
        origin.value = n.unit.empty() ? shortest(n.value) : show(n.value, n.unit);
        origin.source = fmt::format("fitted to {}: {}", fit.data_file,
                                    n.determined ? n.interval_text() : "not determined by it");
      }
  }
  return what;
}

}  // namespace mahlwerk::app
