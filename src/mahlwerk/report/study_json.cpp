// SPDX-FileCopyrightText: 2026 The Mahlwerk authors
// SPDX-License-Identifier: Apache-2.0
#include "mahlwerk/report/study_json.hpp"

#include "mahlwerk/report/match.hpp"
#include "mahlwerk/report/optimum.hpp"
#include "mahlwerk/results/files/json.hpp"

namespace mahlwerk::report {
namespace {

using results::Json;

/// The estimated parameters by name. `fitted`: with what only a fit knows of them.
Json parameters_json(const campaign::ParameterEstimates& found, bool fitted) {
  Json all = Json::object();
  for (const campaign::FittedParameter& p : found.parameters) {
    Json& one = all[p.name] = Json::object({{"value", p.value},
                                            {"low", p.open_low ? Json() : Json(p.low)},
                                            {"high", p.open_high ? Json() : Json(p.high)},
                                            {"unit", p.unit},
                                            {"determined", p.determined}});
    if (fitted) one["by_mills"] = p.simulation_ci95;
    one["range"] = Json::array({p.least, p.most});
    one["remarks"] = p.remarks;
    if (fitted) one["about"] = p.about;
  }
  return all;
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

/// A mean and its half-width.
Json estimate_json(const observe::Estimate& e) {
  return Json::object({{"value", e.mean}, {"ci95", e.ci95}});
}

/// null if the best setting was not checked.
Json check_json(const campaign::Optimum& found) {
  if (!found.check) return nullptr;
  const campaign::OptimumCheck& check = *found.check;
  if (!check.failure.empty())
    return Json::object({{"engine", name_of(check.engine)}, {"not_checked", check.failure}});
  return Json::object({{"engine", name_of(check.engine)},
                       {"value", check.value.mean},
                       {"ci95", check.value.ci95},
                       {"replicates", check.replicates},
                       {"disagrees", found.disagrees()}});
}

Json best_json(const campaign::Optimum& found) {
  if (!found.best) return nullptr;
  const campaign::Trial& s = found.trials[*found.best];
  return Json::object({{"setting", *found.best + 1},
                       {"replicates", s.replicates.size()},
                       {"mean", estimate_json(s.outcome(0))},
                       {"by_model", estimate_json(s.model)},
                       {"chance", s.probability_best},
                       {"certain", found.certain()},
                       {"valid", !s.invalid()},
                       {"check", check_json(found)}});
}

Json keys_json(const campaign::Optimum& found) {
  Json keys = Json::object();
  for (const campaign::KeyOptimum& k : found.keys)
    keys[k.key] = Json::object({{"best", k.text.best},
                                {"low", k.text.low},
                                {"high", k.text.high},
                                {"model", k.text.model},
                                {"good_low", k.text.good_low},
                                {"good_high", k.text.good_high},
                                {"flat", k.flat},
                                {"at_low_end", k.at_low_end},
                                {"at_high_end", k.at_high_end}});
  return keys;
}

Json limits_json(const campaign::Optimum& found) {
  Json limits = Json::array();
  for (const campaign::OptimumLimit& limit : found.limits)
    limits.push_back(Json::object(
        {{"quantity", limit.quantity}, {"limit", limit.text}, {"binds", limit.binds}}));
  return limits;
}

/// Estimates of both engines.
Json pair_json(const EnginePair& pair) {
  return Json::object({{"event", pair.event.mean},
                       {"event_ci95", pair.event.ci95},
                       {"soft", pair.soft.mean},
                       {"soft_ci95", pair.soft.ci95},
                       {"ratio", pair.ratio()},
                       {"ratio_ci95", pair.ratio_ci95()},
                       {"apart", pair.differs()}});
}

Json compared_json(const std::vector<ComparedQuantity>& compared) {
  Json quantities = Json::object();
  for (const ComparedQuantity& q : compared) {
    quantities[q.name] = pair_json(q.estimates);
    quantities[q.name]["unit"] = q.unit;
  }
  return quantities;
}

Json compared_json(const std::vector<ComparedBin>& bins) {
  Json list = Json::array();
  for (const ComparedBin& bin : bins) {
    Json one = pair_json(bin.rate);
    one["low"] = bin.low;
    one["high"] = bin.high;
    list.push_back(one);
  }
  return list;
}

}  // namespace

Json with(Json head, std::initializer_list<Json::Member> members) {
  for (const Json::Member& one : members) head[one.key] = one.value;
  return head;
}

Json study_head(std::string_view study, std::string_view version, std::string_view title,
                std::string_view case_file) {
  return Json::object(
      {{"study", study}, {"mahlwerk", version}, {"title", title}, {"case", case_file}});
}

Json interval_json(const observe::IntervalEstimate& e) {
  return Json::object({{"value", e.value}, {"low", e.low}, {"high", e.high}});
}

Json fit_json(const campaign::Fit& fit, std::string_view version) {
  return with(study_head("fit", version, fit.title, fit.case_file),
              {{"data", fit.data_file},
               {"all_determined", fit.result.all_determined()},
               {"numbers", parameters_json(fit.result, true)},
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
  return with(study_head("calibration", version, found.title, found.case_file),
              {{"data", found.data_file},
               {"all_determined", result.all_determined()},
               {"numbers", parameters_json(result, false)},
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

Json optimum_json(const campaign::Optimum& found, std::string_view version) {
  return with(study_head("optimise", version, found.title, found.case_file),
              {{"quantity", found.outcome.name},
               {"unit", found.outcome.unit},
               {"maximise", found.maximise},
               {"best", best_json(found)},
               {"keys", keys_json(found)},
               {"limits", limits_json(found)},
               {"model_value", estimate_json(found.model_value)},
               {"expected_gain", found.expected_gain},
               {"expected_loss", found.expected_loss},
               {"settings", found.trials.size()},
               {"failed", found.failed},
               {"runs", found.runs()},
               {"remarks", sentences(found)},
               {"notices", results::notices_json(found.notices)}});
}

Json match_json(const campaign::MatchResult& found, std::string_view version) {
  const campaign::Difference& d = found.difference;
  return with(study_head("match", version, found.title_b, found.file_b),
              {{"a", found.file_a},
               {"b", found.file_b},
               {"dose_unit", found.by_powder ? "W/kg" : "W"},
               {"dose_a", estimate_json(d.dose_a)},
               {"dose_b", estimate_json(d.dose_b)},
               {"dose_ratio", interval_json(d.dose)},
               {"energy_lost_mean_a", estimate_json(d.energy_a)},
               {"energy_lost_mean_b", estimate_json(d.energy_b)},
               {"half_power_energy_ratio", interval_json(d.half_power)},
               {"overlap", d.overlap},
               {"spectral_distance", d.spectral},
               {"distance", d.distance},
               {"chance", d.p_value},
               {"within_scatter", d.within_scatter()},
               {"remarks", sentences(found)},
               {"notices", results::notices_json(found.notices)},
               {"search", optimum_json(found.search, version)}});
}

Json comparison_json(const Comparison& c, std::string_view version) {
  Json remarks = Json::array();
  if (!c.caution.empty()) remarks.push_back(c.caution);
  remarks.push_back(how_to_read(c));
  results::NoticeCounts notices;
  for (const EngineDiagnostics* engine : {&c.event, &c.soft}) count(notices, engine->notices);
  sort(notices);
  return with(study_head("compare", version, c.title, c.case_file),
              {{"quantities", compared_json(c.quantities)},
               {"collision_rate_by_impact_speed_normal", compared_json(c.speeds)},
               {"collision_rate_by_energy_normal", compared_json(c.energies)},
               {"remarks", remarks},
               {"notices", results::notices_json(notices)}});
}

}  // namespace mahlwerk::report
