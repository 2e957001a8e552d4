// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/study_json.hpp"

#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::report {
namespace {

using results::Json;

/// The ends of the interval; null where it is open.
Json low_end(const campaign::FittedParameter& p) {
  return p.open_low ? Json() : Json(p.low);
}
Json high_end(const campaign::FittedParameter& p) {
  return p.open_high ? Json() : Json(p.high);
}

Json fitted_numbers(const campaign::Fit& fit) {
  Json numbers = Json::object();
  for (const campaign::FittedParameter& p : fit.result.parameters)
    numbers[p.name] = Json::object({{"value", p.value},
                                    {"low", low_end(p)},
                                    {"high", high_end(p)},
                                    {"unit", p.unit},
                                    {"determined", p.determined},
                                    {"by_mills", p.simulation_ci95},
                                    {"range", Json::array({p.least, p.most})},
                                    {"remarks", p.remarks},
                                    {"about", p.about}});
  return numbers;
}

Json calibrated_numbers(const campaign::Calibration& found) {
  Json numbers = Json::object();
  for (const campaign::FittedParameter& p : found.result.parameters)
    numbers[p.name] = Json::object({{"value", p.value},
                                    {"low", low_end(p)},
                                    {"high", high_end(p)},
                                    {"unit", p.unit},
                                    {"determined", p.determined},
                                    {"range", Json::array({p.least, p.most})},
                                    {"remarks", p.remarks}});
  return numbers;
}

Json calibrated_points(const campaign::Calibration& found) {
  Json points = Json::array();
  for (const campaign::PredictedMeasurement& p : found.points)
    points.push_back(Json::object({{"line", p.line},
                                   {"condition", found.conditions[p.condition]},
                                   {"what", p.name()},
                                   {"unit", p.unit()},
                                   {"measured", p.value},
                                   {"error", p.error},
                                   {"predicted", p.predicted.value},
                                   {"predicted_low", p.predicted.low},
                                   {"predicted_high", p.predicted.high},
                                   {"simulated", p.simulated.mean},
                                   {"simulated_ci95", p.simulated.ci95}}));
  return points;
}

}  // namespace

Json fit_json(const campaign::Fit& fit, std::string_view version) {
  return Json::object({{"mahlwerk", version},
                       {"title", fit.title},
                       {"case", fit.case_file},
                       {"data", fit.data_file},
                       {"all_determined", fit.result.all_determined()},
                       {"numbers", fitted_numbers(fit)},
                       {"correlation", fit.result.correlation},
                       {"conditions", fit.conditions},
                       {"values", fit.points.size()},
                       {"freedom", fit.result.degrees_of_freedom},
                       {"scatter", fit.result.scatter},
                       {"errors_known", fit.errors_known},
                       {"evaluations", fit.result.evaluations},
                       {"remarks", fit.result.remarks},
                       {"notices", results::notices_json(fit.notices)}});
}

Json calibration_json(const campaign::Calibration& found, std::string_view version) {
  const campaign::CalibrationResult& result = found.result;
  return Json::object({{"mahlwerk", version},
                       {"title", found.title},
                       {"case", found.case_file},
                       {"data", found.data_file},
                       {"all_determined", result.all_determined()},
                       {"numbers", calibrated_numbers(found)},
                       {"correlation", result.correlation},
                       {"conditions", found.conditions},
                       {"values", calibrated_points(found)},
                       {"errors_known", found.errors_known},
                       {"misfit", result.misfit},
                       {"scatter", result.scatter},
                       {"settings", result.settings},
                       {"failed", result.failed},
                       {"runs", found.runs},
                       {"converged", result.converged},
                       {"emulator_error", found.emulator_error()},
                       {"emulator_share", result.emulator_share},
                       {"draws", result.draws.size()},
                       {"remarks", result.remarks},
                       {"notices", results::notices_json(found.notices)}});
}

}  // namespace mahlwerk::report
