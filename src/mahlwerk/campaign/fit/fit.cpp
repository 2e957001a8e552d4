// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/campaign/fit/fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "mahlwerk/base/elementary.hpp"
#include "mahlwerk/base/units.hpp"
#include "mahlwerk/campaign/fit/minimiser.hpp"
#include "mahlwerk/cases/grinding.hpp"
#include "mahlwerk/observe/statistics.hpp"
#include "mahlwerk/powder/any_model.hpp"
#include "mahlwerk/results/notices/notice_counts.hpp"
#include "mahlwerk/results/outcome.hpp"

namespace mahlwerk::campaign {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// The first measurement of sizes, or of kinetics; null if there is none.
const Measurement* first(const Measurements& data, bool sizes) {
  const auto found = std::ranges::find_if(data.values, [&](const Measurement& m) {
    return of_powder(m.what) && of_sizes(m.what) == sizes;
  });
  return found == data.values.end() ? nullptr : &*found;
}

}  // namespace

std::vector<FreeParameter> free_parameters(const cases::Case& mill_case,
                                           const std::vector<std::string>& fixed) {
  std::vector<FreeParameter> parameters;
  for (const cases::FitParameter& one : cases::fit_parameters(mill_case)) {
    const auto range = mill_case.fit.find(one.key);
    if (range == mill_case.fit.end() || std::ranges::find(fixed, one.key) != fixed.end()) continue;
    const double least = parse_in(range->second[0], one.unit);
    const double most = parse_in(range->second[1], one.unit);
    parameters.push_back({.name = one.key,
                          .least = least,
                          .most = most,
                          .min_is_natural = least == one.range.least,
                          .max_is_natural = most == one.range.most,
                          .unit = one.unit,
                          .about = one.about});
  }
  return parameters;
}

namespace {

/// Measurements that the model of [kinetics] does not predict.
void kinetics_faults(const cases::Kinetics& kinetics, const Measurements& data,
                     const std::string& file, std::vector<Fault>& found) {
  const auto needs = [&](MeasuredQuantity what, bool predicted, const char* remedy) {
    const auto m = std::ranges::find(data.values, what, &Measurement::what);
    if (predicted || m == data.values.end()) return;
    found.push_back(
        {fmt::format("{}:{}", file, m->line),
         fmt::format("{} was measured, but [kinetics] does not predict it", name_of(what, 0)),
         remedy, "nothing-to-fit"});
  };
  needs(MeasuredQuantity::second_yield, powder::has_second_product(*kinetics.model),
        "write scheme = \"sequential\" or \"parallel\" under model = \"by-impact\"");
  needs(MeasuredQuantity::ignition_time, powder::name_of(*kinetics.model) == "ignition",
        "write model = \"ignition\" in [kinetics]");
}

}  // namespace

std::vector<Fault> fit_faults(const cases::Case& mill_case, const Measurements& data,
                              const std::vector<FreeParameter>& parameters,
                              const std::string& file) {
  std::vector<Fault> found;
  if (parameters.empty())
    found.push_back({mill_case.file, "the case has no free parameter",
                     "add [fit] with keys and their ranges, such as \"breakage.f_mat\" = "
                     "[\"0.01 kg/J/m\", \"100 kg/J/m\"]",
                     "nothing-to-fit"});
  const auto lacks = [&](const Measurement* m, const char* section) {
    found.push_back({fmt::format("{}:{}", file, m->line),
                     fmt::format("{} was measured, but the case has no [{}]",
                                 name_of(m->what, m->percent), section),
                     fmt::format("add [{}] to the case", section), "nothing-to-fit"});
  };
  if (const auto m = std::ranges::find_if(
          data.values, [](const Measurement& one) { return !of_powder(one.what); });
      m != data.values.end())
    found.push_back(
        {fmt::format("{}:{}", file, m->line),
         fmt::format("{} was measured, but [fit] has no key that it depends on", m->name()),
         "add keys of [contact] or [mill] to [fit]", "nothing-to-fit"});
  if (const Measurement* m = first(data, true); m != nullptr && !mill_case.grinding)
    lacks(m, "grinding");
  if (const Measurement* m = first(data, false); m != nullptr && !mill_case.kinetics)
    lacks(m, "kinetics");
  if (mill_case.kinetics) kinetics_faults(*mill_case.kinetics, data, file, found);
  for (const FreeParameter& parameter : parameters)
    if (std::ranges::any_of(data.conditions, [&](const std::vector<cases::Override>& set) {
          return cases::gives_value(set, parameter.name);
        }))
      found.push_back({file, fmt::format("the column {} sets a parameter of [fit]", parameter.name),
                       "remove the column or the key of [fit]", "nothing-to-fit"});
  return found;
}

void fill_times(Measurements& data, const std::vector<cases::Case>& conditions) {
  for (Measurement& m : data.values) {
    const cases::Case& mill_case = conditions[m.condition];
    if (std::isnan(m.time))
      m.time = of_sizes(m.what) ? mill_case.grinding->time : mill_case.kinetics->time;
  }
}

cases::Case case_for_fit(cases::Case mill_case, std::size_t condition, const Measurements& data,
                         const std::vector<FreeParameter>& parameters) {
  mill_case.observe.collisions = false;
  mill_case.observe.frames.reset();
  for (const FreeParameter& parameter : parameters)
    cases::set_fit_parameter(mill_case, parameter.name, value_at(parameter, 0.5));
  if (!mill_case.grinding) return mill_case;
  mill_case.grinding->method = cases::Grinding::Method::balance;
  double longest = 0;
  for (const Measurement& m : data.values)
    if (m.condition == condition && of_sizes(m.what)) longest = std::max(longest, m.time);
  if (longest > 0) mill_case.grinding->time = longest;
  return mill_case;
}

double residual(const Measurement& measured, double predicted) {
  const bool known = !std::isnan(measured.error);
  if (!unit_of(measured.what).empty())  // sizes, surfaces, times
    return math::log(predicted / measured.value) * (known ? measured.value / measured.error : 1);
  return (predicted - measured.value) / (known ? measured.error : 1);
}

namespace {

/// A prediction by all replicates or one of them, from what is kept or by the models.
std::vector<double> prediction_of(const Predictor& predict, FitEvaluations::Replicates of,
                                  const std::vector<double>& values, FitEvaluations* kept) {
  if (kept == nullptr) return predict(values);
  if (const std::vector<double>* known = kept->find(of, values)) return *known;
  std::vector<double> made = predict(values);
  kept->keep(of, values, made);
  return made;
}

double sum_of_squares(const std::vector<double>& residuals) {
  double sum = 0;
  for (const double r : residuals) sum += r * r;
  return sum;
}

/// Evaluations that a fit usually takes: fits of one, two and three parameters took 104 to 130, 246
/// to 351 and 432, with two replicates.
int usual_evaluations(std::size_t parameters, std::size_t replicates) {
  const auto n = static_cast<int>(parameters), r = static_cast<int>(replicates);
  return 130 * n + (r > 1 ? 4 * (n + 1) * r : 0);
}

/// Residuals of predictions from the measurements; counts the evaluations.
struct Evaluator {
  const Measurements& data;
  const FitOptions& options;
  int usual = 0;
  int evaluations = 0;

  Residuals residuals(const Predictor& predict, FitEvaluations::Replicates of = std::nullopt) {
    return [this, &predict, of](const std::vector<double>& values) {
      if (options.stop != nullptr && *options.stop) throw Interrupted();
      std::vector<double> all = prediction_of(predict, of, values, options.kept);
      for (std::size_t i = 0; i < all.size(); ++i) all[i] = residual(data.values[i], all[i]);
      ++evaluations;
      if (options.kept != nullptr && !of) options.kept->note(values, sum_of_squares(all));
      if (options.progress) options.progress(evaluations, std::max(usual, evaluations));
      return all;
    };
  }
};

/// Replicates that every mill has.
std::size_t common_replicates(const std::vector<results::Outcome>& mills) {
  std::size_t replicates = results::averaged_replicates(mills.front()).size();
  for (const results::Outcome& mill : mills)
    replicates = std::min(replicates, results::averaged_replicates(mill).size());
  return replicates;
}

std::vector<double> values_of(const LeastSquaresResult& found) {
  std::vector<double> values;
  for (const FittedParameter& p : found.parameters) values.push_back(p.value);
  return values;
}

/// Half-widths from fits of single replicates, as positions (fit.10).
std::vector<double> simulation_half_widths(const std::vector<results::Outcome>& mills,
                                           const std::vector<FreeParameter>& parameters,
                                           const LeastSquaresResult& found, Evaluator& evaluator) {
  const std::size_t replicates = common_replicates(mills);
  std::vector<std::vector<double>> positions(parameters.size());
  for (std::size_t r = 0; r < replicates && replicates > 1; ++r) {
    const Predictor predict(mills, parameters, evaluator.data.values, evaluator.options.threads, r);
    const Residuals own = evaluator.residuals(predict, r);
    Minimiser search(own, parameters);
    std::vector<double> start;
    for (std::size_t i = 0; i < parameters.size(); ++i)
      start.push_back(position_of(parameters[i], found.parameters[i].value));
    const Evaluation best = search.levenberg_marquardt(search.evaluate(start));
    for (std::size_t i = 0; i < parameters.size(); ++i) positions[i].push_back(best.position[i]);
  }
  std::vector<double> widths;
  for (const std::vector<double>& each : positions)
    widths.push_back(each.empty() ? nothing : observe::estimate(each).ci95);
  return widths;
}

/// Moves the closed ends of an interval outwards by the scatter of the mills (fit.11).
void widen_interval(double width, const FreeParameter& parameter, FittedParameter& p) {
  if (!(width > 0) || !p.determined) return;
  const double position = position_of(parameter, p.value);
  const double below = position - position_of(parameter, p.low),
               above = position_of(parameter, p.high) - position;
  const double low = position - math::hypot(below, width),
               high = position + math::hypot(above, width);
  if (!p.open_low) p.low = value_at(parameter, low);
  if (!p.open_high) p.high = value_at(parameter, high);
  p.open_low = p.open_low || low <= 0;
  p.open_high = p.open_high || high >= 1;
  p.determined = p.determined && !(p.open_low && p.open_high);
  if (width > 0.5 * (below + above))
    p.remarks.emplace_back(
        "its uncertainty comes mainly from the scatter of the simulated mill: a "
        "longer run or more replicates reduce it");
}

/// Widens the interval by the scatter of the mills, given as a half-width of positions.
void add_simulation_scatter(double width, const FreeParameter& parameter, FittedParameter& p) {
  const double position = position_of(parameter, p.value);
  widen_interval(width, parameter, p);
  p.simulation_ci95 =  // value_at limits positions to the range
      0.5 * (value_at(parameter, position + width) - value_at(parameter, position - width));
  p.text = texts_of(p);
}

/// Number of digits with which two different numbers are shown as different.
int digits_for(double low, double high) {
  const double apart = std::abs(high - low), size = std::fmax(std::abs(low), std::abs(high));
  if (!(apart > 0) || !(size > 0)) return 4;
  return std::clamp(2 + static_cast<int>(std::ceil(math::log10(size / apart))), 3, 8);
}

}  // namespace

ParameterTexts texts_of(const FittedParameter& p) {
  const auto text = [&](double number) {
    return show_rounded(number, p.unit, digits_for(p.low, p.high));
  };
  return {text(p.value), text(p.low), text(p.high), show_rounded(p.least, p.unit),
          show_rounded(p.most, p.unit)};
}

Fit fit(const std::vector<results::Outcome>& mills, const Measurements& data,
        const std::vector<FreeParameter>& parameters, const FitOptions& options) {
  Evaluator evaluator{.data = data,
                      .options = options,
                      .usual = usual_evaluations(parameters.size(), common_replicates(mills))};
  const Predictor predict(mills, parameters, data.values, options.threads);
  const ErrorScale scatter = data.errors_known() ? ErrorScale::known : ErrorScale::estimated;
  Fit made;
  made.result = least_squares(evaluator.residuals(predict), parameters, scatter);
  const std::vector<double> predicted = predict(values_of(made.result));
  for (std::size_t i = 0; i < predicted.size(); ++i)
    made.points.push_back(
        {data.values[i], {.value = predicted[i]}, residual(data.values[i], predicted[i])});
  const std::vector<double> widths =
      simulation_half_widths(mills, parameters, made.result, evaluator);
  made.result.evaluations = evaluator.evaluations;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    add_simulation_scatter(widths[i], parameters[i], made.result.parameters[i]);
  for (const results::Outcome& mill : mills) results::count(made.notices, mill.notices);
  results::sort(made.notices);
  const auto unknown_scatter = [](const FittedParameter& p) {
    return std::isnan(p.simulation_ci95);
  };
  if (std::ranges::any_of(made.result.parameters, unknown_scatter))
    made.result.remarks.emplace_back(
        "the mill ran one replicate: the contribution of its scatter to the intervals is not "
        "known");
  return made;
}

}  // namespace mahlwerk::campaign
